// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A step of free rotation of one body by the kernel's turns.
#pragma once

#include "motion/rigid_body.h"

namespace ellipsoid {

/// Orientation and angular velocity (rad/time, space frame) of a body.
struct Rotating {
  Quaternion orientation;
  Vector3 omega;
};

/// @param[in] momentum angular momentum (space frame), constant
/// @param[in] inverse_inertia inverse() of the principal moments
/// @return orientation and angular velocity after the step
inline Rotating rotate_freely(const Quaternion& orientation, const Vector3& momentum,
                              const Vector3& inverse_inertia, double time_step) {
  FreeRotation body{orientation, rotation(orientation).to_body(momentum)};
  body.turn_zy(inverse_inertia, time_step);
  body.turn_xyz(inverse_inertia, time_step);
  body.q = normalized(body.q);
  return {body.q, body.omega(inverse_inertia)};
}

} // namespace ellipsoid
