// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Free rotation of many bodies at once: the functions of rigid_body.h in loops that the compiler turns
// into vector instructions. The results are those of the functions, bit for bit.
#pragma once

#include "batch.h"
#include "rigid_body.h"

namespace ellipsoid {

/// rotate_freely() and angular_velocity().
class RotationBatch : public Batch {
 public:
  /// @param[in] momentum angular momentum (space frame), @param[in] inertia principal moments
  void add(const Quaternion& orientation, const Vector3& momentum, const Vector3& inertia);

  /// Advances all bodies.
  void solve(double time_step);

  Quaternion orientation(int k) const; ///< of body k after the step
  Vector3 omega(int k) const;          ///< its angular velocity there (rad/time, space frame)

  /// Columns of numbers, one per body.
  struct Columns {
    enum Value { qw, qx, qy, qz, mx, my, mz, ix, iy, iz, wx, wy, wz, value_count };
    alignas(64) double values[value_count][column_length];
    double time_step;
  };

private:
  Columns columns_;
};

} // namespace ellipsoid
