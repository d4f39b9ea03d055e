// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Pairs of neighbours that are apart, and when they have to be looked at again.
//
// Surfaces that are apart cannot touch before the two bodies together have travelled their gap:
// until then the pair sleeps. Nobody has to ask every pair in every step: the gap is divided
// between the two, each gets a deadline, and neither looks at the pair before its own path has
// come to its deadline. The proof is exact whatever the shares are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ellipsoid {

/// How far any point of each body has moved at most, as the sum over all steps since restart().
class Travels {
 public:
  /// All paths are 0.
  void restart(std::size_t bodies) {
    path_.assign(bodies, 0.0);
    last_.assign(bodies, 0.0);
  }
  /// @param[in] way of the body in one step (length)
  void add(std::size_t body, double way) {
    path_[body] += way;
    last_[body] = way;
  }
  std::size_t size() const { return path_.size(); }
  double path(int body) const { return path_[static_cast<std::size_t>(body)]; }
  /// Way in the last step (length).
  double last(int body) const { return last_[static_cast<std::size_t>(body)]; }

 private:
  std::vector<double> path_, last_;
};

class SleepingPairs {
 public:
  /// New pairs, all of them awake; bodies are numbered from 0.
  /// @param[in] for_each_pair for_each_pair(visit) calls visit(i, j) for the pair of each place, 0, 1,
  ///            2 ...; all pairs with the same `i` follow each other. It is called twice.
  template <class ForEachPair> void restart(std::size_t bodies, const ForEachPair& for_each_pair) {
    begin(bodies);
    for_each_pair([this](int i, int j) { count(i, j); });
    make_room();
    std::size_t place = 0;
    for_each_pair([this, &place](int i, int j) { connect(place++, i, j); });
  }

  std::size_t size() const { return size_; }
  /// Place of the first pair with this `i`.
  std::size_t first_place(int i) const { return bodies_[static_cast<std::size_t>(i)].first_place; }

  /// The pair of body `i` at this place sleeps until its bodies have travelled the gap (length, > 0).
  void sleep(std::size_t place, int i, double gap, const Travels& travels);

  /// Wakes the pairs that are due: on_due(place, i, j) for each.
  template <class OnDue> void wake(const Travels& travels, const OnDue& on_due) {
    for (std::size_t body = 0; body < looks_at_.size(); ++body)
      if (travels.path(static_cast<int>(body)) >= looks_at_[body])
        look(static_cast<int>(body), travels, on_due);
  }

 private:
  static constexpr float never = std::numeric_limits<float>::infinity();
  /// A body has one entry for each of its pairs: first those with it as `i`.
  struct Body {
    std::size_t first_place = 0;
    std::size_t begin = 0; ///< of its entries
    std::uint32_t as_first = 0, as_second = 0;
    std::size_t end() const { return begin + as_first + as_second; }
  };
  /// The same pair in the other body's list.
  struct Twin {
    int body;
    std::uint32_t entry;
  };
  std::vector<Body> bodies_;
  std::size_t size_ = 0;
  std::vector<float> looks_at_;  ///< least deadline of each body
  std::vector<float> deadlines_; ///< by entry: path of the body (length); never: the pair is awake
  std::vector<Twin> twins_;      ///< by entry

  void begin(std::size_t bodies);
  void count(int i, int j);
  void make_room();
  void connect(std::size_t place, int i, int j);
  void divide(int body, std::size_t entry, double left, const Travels& travels);

  template <class OnDue> void look(int body, const Travels& travels, const OnDue& on_due) {
    const Body& own = bodies_[static_cast<std::size_t>(body)];
    const double path = travels.path(body);
    for (std::size_t entry = own.begin; entry < own.end(); ++entry)
      if (deadlines_[entry] <= path)
        look_at_pair(body, entry, travels, on_due);
    float least = never;
    for (std::size_t entry = own.begin; entry < own.end(); ++entry)
      least = std::min(least, deadlines_[entry]);
    looks_at_[static_cast<std::size_t>(body)] = least;
  }

  template <class OnDue>
  void look_at_pair(int body, std::size_t entry, const Travels& travels, const OnDue& on_due) {
    const Twin twin = twins_[entry];
    const double until = static_cast<double>(deadlines_[entry]) + deadlines_[twin.entry];
    const double left = until - (travels.path(body) + travels.path(twin.body));
    if (left > 0.0) {
      divide(body, entry, left, travels);
      return;
    }
    deadlines_[entry] = deadlines_[twin.entry] = never;
    const Body &own = bodies_[static_cast<std::size_t>(body)],
               &other = bodies_[static_cast<std::size_t>(twin.body)];
    if (entry < own.begin + own.as_first)
      on_due(own.first_place + (entry - own.begin), body, twin.body);
    else
      on_due(other.first_place + (twin.entry - other.begin), twin.body, body);
  }
};

} // namespace ellipsoid
