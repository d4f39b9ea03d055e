// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The ways of particles from one frame to the next, through edges that repeat.
#pragma once

#include "particles.h"
#include "periodic_cell.h"

namespace ellipsoid::post {

/// Knows the boxes of two frames that follow each other, and how they name positions.
class FrameSteps {
 public:
  /// The next frame.
  void advance(const ParticleSet& set, const PeriodicCell& cell);

  /// The way of a particle between the last two frames (length), of that image which was in the
  /// box before: the way that unwrapped positions tell, else the shortest one.
  /// @param[in] before, now its centres as the frames name them (length)
  Vector3 way(const Vector3& before, const Vector3& now) const;

  /// Whether a way is longer than 0.4 of an edge that repeats and was taken for the shortest one:
  /// that one is at most half of an edge, and may be another than that which was gone. Unwrapped
  /// positions leave no doubt.
  bool is_doubtful(const Vector3& way) const;

  /// Whether a way is longer than a whole edge that repeats: it may come to one place twice.
  bool goes_around(const Vector3& way) const { return largest_share(way) > 1.0; }

 private:
  double largest_share(const Vector3& way) const; ///< of an edge that repeats

  PeriodicCell before_, now_;
  bool was_unwrapped_ = false, is_unwrapped_ = false;
};

} // namespace ellipsoid::post
