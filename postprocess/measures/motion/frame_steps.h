// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The ways of particles from one frame to the next, through edges that repeat.
#pragma once

#include "particles.h"
#include "periodic_cell.h"

namespace ellipsoid::post {

/// Steps whose ways may be others than they are taken for.
struct LongSteps {
  std::size_t doubtful =
      0; ///< longer than 0.4 of an edge that repeats, taken for the shortest ones
  std::size_t by_flags = 0; ///< longer than half of it, as flags or unwrapped positions say

  LongSteps& operator+=(const LongSteps& other) {
    doubtful += other.doubtful;
    by_flags += other.by_flags;
    return *this;
  }
};

/// Knows the boxes of two frames that follow each other, and how they name positions.
class FrameSteps {
 public:
  /// The next frame.
  void advance(const ParticleSet& set, const PeriodicCell& cell);

  /// The place by which a particle of the last frame is followed: its unwrapped centre where the
  /// frame has it, else its centre (length).
  const Vector3& place(const Particle& particle) const {
    return knows_ways_ ? particle.unwrapped_centre : particle.centre;
  }

  /// The way of a particle between the last two frames (length), of that image which was in the
  /// box before: the way that unwrapped positions tell, else the shortest one.
  /// @param[in] before, now its places (length)
  Vector3 way(const Vector3& before, const Vector3& now) const;

  /// Counts a way that may be another. The shortest one is at most half of an edge, and may be
  /// another than that which was gone. Flags leave no doubt, but for spheres of the host's bodies.
  void count_long(const Vector3& way, LongSteps& steps) const;

  /// Whether a way is longer than a whole edge that repeats: it may come to one place twice.
  bool goes_around(const Vector3& way) const { return largest_share(way) > 1.0; }

 private:
  double largest_share(const Vector3& way) const; ///< of an edge that repeats

  PeriodicCell before_, now_;
  bool knew_ways_ = false, knows_ways_ = false;
};

} // namespace ellipsoid::post
