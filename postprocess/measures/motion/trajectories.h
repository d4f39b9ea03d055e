// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How far particles have gone and turned since earlier frames of a run.
#pragma once

#include "frame_steps.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace ellipsoid::post {

/// Means over particles (and origins) that a lag apart are both there.
struct LagMeans {
  std::size_t pairs = 0;         ///< of a particle and an origin
  std::size_t rotations = 0;     ///< of these, where the file tells the whole orientation
  std::size_t directions = 0;    ///< of these, where it tells at least the body's axis
  Vector3 displacement;          ///< mean (length)
  Vector3 squared_displacement;  ///< mean of the squares of the components (length^2)
  double squared_rotation = 0.0; ///< mean square of the angle vector (rad^2), of the rotations
  /// Mean of u(0) . u(t), u along the body's longest semi-axis, of the directions.
  double direction = 0.0;
  double direction_p2 = 0.0; ///< mean of P2(u(0) . u(t)), of the directions
};

/// Follows particles by their ids from frame to frame; needs memory for one frame and the origins.
/// Between two frames a particle must move less than half of an edge that repeats (unwrapped
/// positions: any way), and turn by less than half a turn.
class Trajectories {
 public:
  /// @param[in] origins frames kept to compare with, the first ones
  /// @param[in] apart frames from one origin to the next
  Trajectories(std::size_t origins, std::size_t apart) : most_(origins), apart_(apart) {}

  /// The next frame; the cell is that of the frame.
  void add(const ParticleSet& set, const PeriodicCell& cell);

  /// Means by the number of frames between origin and frame.
  const std::map<std::size_t, LagMeans>& sums() const { return sums_; }
  /// Means of one lag.
  LagMeans means(std::size_t lag) const;

  /// Steps from frame to frame that may not be the shortest ones, see FrameSteps.
  const LongSteps& long_steps() const { return long_steps_; }

  /// Way of a particle since it was first seen (length).
  Vector3 way(std::int64_t id) const { return states_.at(id).way; }
  /// Nothing where the file does not tell how the particle lies.
  std::optional<Vector3> rotation_vector(std::int64_t id) const;

 private:
  struct State {
    Vector3 place; ///< of the last frame, see FrameSteps
    Quaternion orientation;
    KnownOrientation known = KnownOrientation::whole; ///< the least of all frames of its way
    Vector3 way, angle;                               ///< summed up since it was first seen
    Vector3 direction;                                ///< of the longest semi-axis
    std::size_t first_seen = 0, last_seen = 0;        ///< numbers of the frames of its way
  };
  struct Origin {
    std::size_t frame = 0;
    std::map<std::int64_t, State> states;
  };

  void move(const ParticleSet& set);
  void compare(const Origin& origin);

  std::size_t most_, apart_, frame_ = 0;
  LongSteps long_steps_;
  FrameSteps steps_;
  std::map<std::int64_t, State> states_;
  std::vector<Origin> origins_;
  std::map<std::size_t, LagMeans> sums_;
};

/// The vector of the rotation from p to q: axis times angle, at most half a turn (rad).
Vector3 rotation_between(const Quaternion& p, const Quaternion& q);

} // namespace ellipsoid::post
