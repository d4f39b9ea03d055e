// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Pairs of neighbours that are apart, and when they have to be looked at again.
//
// Bodies that are apart stay apart until the clock of one of them reaches a deadline
// (motion_clocks.h): until then the pair sleeps. Nobody has to ask every pair in every step: a body
// looks at its pairs only when its clock has come to the first of their deadlines.
#pragma once

#include "separation/motion_clocks.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ellipsoid {

class SleepingPairs {
 public:
  /// New pairs, all of them awake; bodies are numbered from 0.
  /// @param[in] for_each_pair for_each_pair(visit) calls visit(i, j) for the pair of each place, 0,
  /// 1,
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

  /// The pair of body `i` at this place sleeps until its bodies may have come as close as the gap.
  /// @param[in] gap > 0, @param[in] approach in a step, see MotionClocks (length)
  void sleep(std::size_t place, int i, double gap, double approach, MotionClocks& clocks);

  /// Wakes the pairs that are due: on_due(place, i, j) for each; after_some() now and then, where
  /// pairs may be sent to sleep again.
  template <class OnDue, class AfterSome>
  void wake(const MotionClocks& clocks, const OnDue& on_due, const AfterSome& after_some) {
    int due[block];
    for (std::size_t first = 0; first < looks_at_.size(); first += block) {
      const int count = find_due(first, clocks, due);
      for (int k = 0; k < count; ++k)
        look(due[k], clocks.time(due[k]), on_due);
      after_some();
    }
  }
  template <class OnDue> void wake(const MotionClocks& clocks, const OnDue& on_due) {
    wake(clocks, on_due, [] {});
  }

 private:
  static constexpr std::size_t block = 64; ///< of bodies
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
  std::vector<float> deadlines_; ///< by entry: time of the body; never: the pair is awake
  std::vector<Twin> twins_;      ///< by entry
  std::vector<std::size_t> due_; ///< as many as the largest number of entries of a body

  void begin(std::size_t bodies);
  void count(int i, int j);
  void make_room();
  void connect(std::size_t place, int i, int j);
  void set_deadline(int body, std::size_t entry, double time);

  // Which bodies and pairs are due cannot be foreseen: no branch depends on it.

  /// Bodies of a block whose clocks have come to the first of their deadlines.
  /// @return how many
  int find_due(std::size_t first, const MotionClocks& clocks, int* due) const {
    const std::size_t end = std::min(first + block, looks_at_.size());
    const double* times = clocks.times();
    int count = 0;
    for (std::size_t body = first; body < end; ++body) {
      due[count] = static_cast<int>(body);
      count += times[body] >= looks_at_[body];
    }
    return count;
  }

  template <class OnDue> void look(int body, double time, const OnDue& on_due) {
    const Body& own = bodies_[static_cast<std::size_t>(body)];
    const std::size_t end = own.end();
    const float now = static_cast<float>(time); // rounded: too early at worst
    const float* deadlines = deadlines_.data();
    std::size_t* due = due_.data();
    std::size_t count = 0;
    float least = never;
    for (std::size_t entry = own.begin; entry < end; ++entry) {
      const float deadline = deadlines[entry];
      due[count] = entry;
      count += deadline <= now;
      least = std::min(least, deadline <= now ? never : deadline);
    }
    looks_at_[static_cast<std::size_t>(body)] = least;
    for (std::size_t k = 0; k < count; ++k)
      wake_pair(body, due[k], on_due);
  }

  template <class OnDue> void wake_pair(int body, std::size_t entry, const OnDue& on_due) {
    const Twin twin = twins_[entry];
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
