// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Pairs of neighbours that are apart, and when each has to be checked again (conservative
// advancement).
//
// Bodies that are apart stay apart until the clock of one of them reaches a deadline
// (motion_clocks.h): until then the check of the pair is deferred. A step does not go through all
// pairs: those of a body are checked only when its clock has come to the first of their deadlines.
#pragma once

#include "separation/motion_clocks.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ellipsoid {

class DeferredChecks {
 public:
  /// New pairs, none of them deferred; bodies are numbered from 0, pairs too: by their index.
  /// @param[in] for_each_pair for_each_pair(visit) calls visit(i, j) for the pairs 0, 1, 2 ...; all
  ///            pairs with the same `i` follow each other. It is called twice.
  template <class ForEachPair> void restart(std::size_t bodies, const ForEachPair& for_each_pair) {
    begin(bodies);
    for_each_pair([this](int i, int j) { count(i, j); });
    make_room();
    std::size_t index = 0;
    for_each_pair([this, &index](int i, int j) { connect(index++, i, j); });
  }

  /// Number of pairs.
  std::size_t size() const { return size_; }
  /// Index of the first pair with this `i`.
  std::size_t first_index(int i) const { return bodies_[static_cast<std::size_t>(i)].first_index; }

  /// The check of this pair of body `i` is deferred until its bodies may have come as close as the
  /// gap.
  /// @param[in] gap > 0, @param[in] approach in a step, see MotionClocks (length)
  void defer(std::size_t index, int i, double gap, double approach, MotionClocks& clocks);

  /// Ends the deferral of the pairs that are due: on_due(index, i, j) for each; after_block() now
  /// and then, where pairs may be deferred again.
  template <class OnDue, class AfterBlock>
  void end_due(const MotionClocks& clocks, const OnDue& on_due, const AfterBlock& after_block) {
    int due[block];
    for (std::size_t first = 0; first < first_deadlines_.size(); first += block) {
      const int count = find_due_bodies(first, clocks, due);
      for (int k = 0; k < count; ++k)
        end_due_of(due[k], clocks.time(due[k]), on_due);
      after_block();
    }
  }
  template <class OnDue> void end_due(const MotionClocks& clocks, const OnDue& on_due) {
    end_due(clocks, on_due, [] {});
  }

 private:
  static constexpr std::size_t block = 64; ///< of bodies
  static constexpr float never = std::numeric_limits<float>::infinity();
  /// A body has one entry for each of its pairs: first those with it as `i`.
  struct Body {
    std::size_t first_index = 0;
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
  std::vector<float> first_deadlines_; ///< of each body
  std::vector<float> deadlines_;       ///< by entry: time of the body; never: not deferred
  std::vector<Twin> twins_;            ///< by entry
  std::vector<std::size_t> due_;       ///< as many as the largest number of entries of a body

  void begin(std::size_t bodies);
  void count(int i, int j);
  void make_room();
  void connect(std::size_t index, int i, int j);
  void set_deadline(int body, std::size_t entry, double time);

  // Which bodies and pairs are due cannot be foreseen: no branch depends on it.

  /// Bodies of a block whose clocks have come to the first of their deadlines.
  /// @return how many
  int find_due_bodies(std::size_t first, const MotionClocks& clocks, int* due) const {
    const std::size_t end = std::min(first + block, first_deadlines_.size());
    const double* times = clocks.times();
    int count = 0;
    for (std::size_t body = first; body < end; ++body) {
      due[count] = static_cast<int>(body);
      count += times[body] >= first_deadlines_[body];
    }
    return count;
  }

  template <class OnDue> void end_due_of(int body, double time, const OnDue& on_due) {
    const Body& own = bodies_[static_cast<std::size_t>(body)];
    const std::size_t end = own.end();
    const float now = static_cast<float>(time); // rounded: too early at worst
    const float* deadlines = deadlines_.data();
    std::size_t* due = due_.data();
    std::size_t count = 0;
    float first = never;
    for (std::size_t entry = own.begin; entry < end; ++entry) {
      const float deadline = deadlines[entry];
      due[count] = entry;
      count += deadline <= now;
      first = std::min(first, deadline <= now ? never : deadline);
    }
    first_deadlines_[static_cast<std::size_t>(body)] = first;
    for (std::size_t k = 0; k < count; ++k)
      end_deferral(body, due[k], on_due);
  }

  template <class OnDue> void end_deferral(int body, std::size_t entry, const OnDue& on_due) {
    const Twin twin = twins_[entry];
    deadlines_[entry] = deadlines_[twin.entry] = never;
    const Body &own = bodies_[static_cast<std::size_t>(body)],
               &other = bodies_[static_cast<std::size_t>(twin.body)];
    if (entry < own.begin + own.as_first)
      on_due(own.first_index + (entry - own.begin), body, twin.body);
    else
      on_due(other.first_index + (twin.entry - other.begin), twin.body, body);
  }
};

} // namespace ellipsoid
