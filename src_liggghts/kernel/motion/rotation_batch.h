// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Free rotation of many bodies at once: the turns of FreeRotation in loops that the compiler turns
// into vector instructions. The results are those of the function, bit for bit.
#pragma once

#include "motion/rigid_body.h"
#include "vectorised/batch.h"

namespace ellipsoid {

class RotationBatch : public Batch {
 public:
  /// @param[in] momentum angular momentum (space frame)
  /// @param[in] inverse_inertia inverse() of the principal moments
  void add(const Quaternion& orientation, const Vector3& momentum, const Vector3& inverse_inertia);

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

// Inline, and number by number, as contact_batch.h.

inline void RotationBatch::add(const Quaternion& orientation, const Vector3& momentum,
                               const Vector3& inverse_inertia) {
  using C = Columns;
  const int k = next();
  const auto put = [this, k](int column, double value) { columns_.values[column][k] = value; };
  put(C::qw, orientation.w);
  put(C::qx, orientation.x);
  put(C::qy, orientation.y);
  put(C::qz, orientation.z);
  put(C::mx, momentum.x);
  put(C::my, momentum.y);
  put(C::mz, momentum.z);
  put(C::ix, inverse_inertia.x);
  put(C::iy, inverse_inertia.y);
  put(C::iz, inverse_inertia.z);
}

inline Quaternion RotationBatch::orientation(int k) const {
  using C = Columns;
  const auto& values = columns_.values;
  return {values[C::qw][k], values[C::qx][k], values[C::qy][k], values[C::qz][k]};
}

inline Vector3 RotationBatch::omega(int k) const {
  using C = Columns;
  const auto& values = columns_.values;
  return {values[C::wx][k], values[C::wy][k], values[C::wz][k]};
}

} // namespace ellipsoid
