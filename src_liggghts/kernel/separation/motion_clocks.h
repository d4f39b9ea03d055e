// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How long bodies that are apart stay apart, whatever happens to them.
//
// In one step a body is displaced by w, and what else it does changes its reach in any direction by
// no more than t (its turn). Two bodies a gap g apart along the unit normal n, from i to j, that
// went on like that would come closer by
//   c = n.(w_i - w_j) + t_i + t_j
// in every step: motion that they have in common costs nothing. But motions change, by
// |w' - w| + |t' - t| from one step to the next. Every body has a clock that adds up these changes,
// and advances by a pace of its own besides. m steps later the gap is at least
//   g - m (c + change_i + change_j).
// As long as both clocks have advanced by less than k times their paces, the changes are less than
// (k - m)(p_i + p_j). With p = p_i + p_j the gap then stays positive if
//   k = g / c                     where c >= sqrt(p g),
//   k = (2 sqrt(p g) - c) / p     elsewhere.
// This is true of any paces; paces near the usual change of a step make k p last longest.
//
// Most pairs of a neighbour list are too far apart to be worth a proof of their own. Each body has
// a margin, too: a length that |w| + t use up step by step. Two bodies that are farther apart than
// both their margins stay apart until one of the margins is used up.
#pragma once

#include "math/vector3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ellipsoid {

/// Of a body in one step.
struct Motion {
  Vector3 displacement; ///< (length)
  double turn = 0.0;    ///< by which its reach in any direction changed at most besides (length)
};

/// Motions of some bodies that follow each other.
struct Motions {
  static constexpr int capacity = 64;
  alignas(64) double displacements[3 * capacity]; ///< 3 each (length)
  alignas(64) double turns[capacity];             ///< (length)
  int count = 0;

  void set(int k, const Motion& motion) {
    displacements[3 * k] = motion.displacement.x;
    displacements[3 * k + 1] = motion.displacement.y;
    displacements[3 * k + 2] = motion.displacement.z;
    turns[k] = motion.turn;
  }
};

class MotionClocks {
 public:
  /// All clocks stand at 0.
  void restart(std::size_t bodies) {
    const double pace = std::max(smallest_pace, first_pace_share * usual_change());
    displacement_.assign(3 * bodies, 0.0);
    turn_.assign(bodies, 0.0);
    pace_.assign(bodies, pace);
    time_.assign(bodies, 0.0);
    margin_.assign(bodies, 0.0);
    used_up_ = 0;
    steps_ = pace_per_time_ = 0.0;
  }
  /// Before restart(): the clocks are then as new ones. A run that is set up in the middle goes on
  /// like one that is read from a restart file.
  void forget() { steps_ = 0.0; }
  /// What the first motion is compared with: a guess of it, good or bad.
  void expect(std::size_t body, const Motion& motion) {
    displacement_[3 * body] = motion.displacement.x;
    displacement_[3 * body + 1] = motion.displacement.y;
    displacement_[3 * body + 2] = motion.displacement.z;
    turn_[body] = motion.turn;
  }

  /// From now on the body may move by so much (length). What is left of it is its margin().
  void set_margin(std::size_t body, double margin) { margin_[body] = trusted_share * margin; }
  double margin(int body) const { return margin_[static_cast<std::size_t>(body)]; }
  /// Whether a body has moved by more than its margin when the last step ended.
  bool a_margin_is_used_up() const { return used_up_ > 0; }

  /// To be called once per step, before all advance().
  void begin_step() {
    steps_ += 1.0;
    pace_per_time_ = pace_share / steps_;
    used_up_ = 0;
  }
  /// @param[in] motions of bodies in this step, from body `first` on
  void advance_from(std::size_t first, const Motions& motions);
  void advance(std::size_t body, const Motion& motion) {
    Motions one;
    one.count = 1;
    one.set(0, motion);
    advance_from(body, one);
  }

  /// A step of all bodies, some at a time.
  /// @param[in] measure measure(first, motions): the motions of as many bodies as motions.count
  /// says,
  ///            from body `first` on
  template <class Measure> void advance_all(const Measure& measure) {
    begin_step();
    Motions motions;
    for (std::size_t first = 0; first < size(); first += Motions::capacity) {
      motions.count = static_cast<int>(std::min<std::size_t>(Motions::capacity, size() - first));
      measure(first, motions);
      advance_from(first, motions);
    }
  }

  std::size_t size() const { return time_.size(); }
  /// Of a body's clock (length).
  double time(int body) const { return time_[static_cast<std::size_t>(body)]; }

  const double* times() const { return time_.data(); }

  /// By how much the bodies come closer in a step (length; negative: they part).
  /// @param[in] normal unit, from i to j: along which their gap is measured
  double approach(int i, int j, const Vector3& normal) const {
    const Motion of_i = motion(i), of_j = motion(j);
    return dot(normal, of_i.displacement - of_j.displacement) + of_i.turn + of_j.turn;
  }
  /// The same for a gap in any direction.
  double approach(int i, int j) const {
    const Motion of_i = motion(i), of_j = motion(j);
    return norm(of_i.displacement - of_j.displacement) + of_i.turn + of_j.turn;
  }

  /// Times of the two clocks.
  struct Deadlines {
    double i, j;
  };
  /// Until one of the clocks reaches its deadline the bodies are apart.
  /// @param[in] gap > 0: by which they are apart now (length)
  Deadlines deadlines(int i, int j, double gap, double approach) {
    const double pace_i = pace(i), pace_j = pace(j), both = pace_i + pace_j;
    const double trusted = trusted_share * gap, root = std::sqrt(both * trusted);
    const double steps = approach >= root ? trusted / approach : (2.0 * root - approach) / both;
    return {time(i) + steps * pace_i, time(j) + steps * pace_j};
  }
  /// What the body moves in a step (length).
  double way(std::size_t body) const {
    const Motion own = motion(static_cast<int>(body));
    return norm(own.displacement) + own.turn;
  }
  /// The gap that is good for so many steps if motions change as usual (length, >= 0).
  double gap_for(double steps, int i, int j, double approach) {
    const double both = pace(i) + pace(j), least = both * steps;
    return approach >= least ? steps * approach
                             : (least + approach) * (least + approach) / (4.0 * both);
  }

 private:
  /// Motions are differences of positions, which are rounded: so much of a gap is relied upon.
  static constexpr double trusted_share = 1.0 - 1e-9;
  /// For bodies that have never moved: deadlines in single precision can be told from 0 (length).
  static constexpr double smallest_pace = 1e-30;

  /// Paces that make the most of gaps are near the usual change; how near hardly matters.
  static constexpr double first_pace_share = 0.25, pace_share = 0.7;

  std::vector<double> displacement_, turn_; // in the last step: 3 numbers and one per body
  std::vector<double> pace_; // never slows down: deadlines were made with it (length)
  std::vector<double> time_;
  std::vector<double> margin_; // what is left of it (length)
  int used_up_ = 0;            // margins
  double steps_ = 0.0;         // since restart()
  double pace_per_time_ = 0.0; // of the clock

  Motion motion(int body) const {
    const auto b = static_cast<std::size_t>(body);
    return {{displacement_[3 * b], displacement_[3 * b + 1], displacement_[3 * b + 2]}, turn_[b]};
  }

  /// Mean change of motion in a step, of all bodies; clocks advance by it and by paces near it.
  double usual_change() const {
    double sum = 0.0;
    for (const double time : time_)
      sum += time;
    return steps_ > 0.0 && !time_.empty() ? 0.5 * sum / (steps_ * static_cast<double>(size()))
                                          : 0.0;
  }

  /// The body's pace; it grows with the time that its clock takes for a step.
  double pace(int body) {
    double& pace = pace_[static_cast<std::size_t>(body)];
    pace = std::max(pace, pace_per_time_ * time(body));
    return pace;
  }
};

} // namespace ellipsoid
