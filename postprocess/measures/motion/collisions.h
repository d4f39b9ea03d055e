// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Collisions of pairs of particles in a series of frames: when they touch, for how long, how fast
// they came.
#pragma once

#include "contact_forces.h"
#include "periodic_cell.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace ellipsoid::post {

/// A pair that came together and parted again.
struct Collision {
  std::int64_t id_1 = 0, id_2 = 0;
  double begin = 0.0, end = 0.0; ///< in the middle of the frames between which it was (time)
  /// In the last frame before the contact, at its point: speed of approach along the normal, and
  /// across it (velocity).
  double normal_speed = 0.0, tangential_speed = 0.0;
  double largest_overlap = 0.0; ///< in the frames (length)
  double departure_speed = 0.0; ///< along the normal in the first frame after it (velocity)
};

/// A pair that touches: the engine's contact of it, or one of a list.
struct TouchingPair {
  std::size_t i = 0, j = 0; ///< indices of the set
  Vector3 point, normal;    ///< (length), unit from i to j
  double overlap = 0.0;     ///< the largest of the pair (length)
};

/// Recomputed from positions with the engine's kernel; of several contacts of a pair the first.
std::vector<TouchingPair> touching_pairs(const ParticleSet& set);
/// As a list has them; the first row of each pair.
/// Throws InputError when the list names a particle that is not there.
std::vector<TouchingPair> listed_pairs(const Frame& list, const ContactColumns& columns,
                                       const ParticleSet& set);

/// Follows all pairs from frame to frame. Times are known to the distance of the frames.
class Collisions {
 public:
  /// The next frame and its touching pairs. Throws InputError without velocities and
  /// angular velocities.
  /// @return the collisions that ended before it
  std::vector<Collision> advance(const ParticleSet& set, const std::vector<TouchingPair>& pairs,
                                 double time);

  std::size_t from_the_start() const { return from_the_start_; } ///< pairs not seen to begin
  std::size_t not_ended() const { return touching_.size(); }     ///< pairs that touch now

 private:
  struct Touching {
    Collision collision;
    Vector3 normal, lever_1, lever_2; ///< of the first frame of the contact; from the centres
    bool is_whole = false;            ///< its beginning was seen
  };
  struct Motion {
    Vector3 velocity, spin;
  };
  using Pair = std::pair<std::int64_t, std::int64_t>;

  static Vector3 relative_velocity(const Motion& first, const Motion& second,
                                   const Touching& contact);
  Touching begun(const ParticleSet& set, const TouchingPair& pair, double time) const;
  std::vector<Collision> ended(const std::map<std::int64_t, Motion>& motions, double time) const;

  bool has_frame_ = false;
  double time_ = 0.0; ///< of the last frame
  std::size_t from_the_start_ = 0;
  std::map<Pair, Touching> touching_;
  std::map<std::int64_t, Motion> motions_; ///< of the last frame
};

} // namespace ellipsoid::post
