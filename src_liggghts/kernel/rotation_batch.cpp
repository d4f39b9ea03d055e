// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "rotation_batch.h"

#include "vector_versions.h"

namespace ellipsoid {

namespace {

using Columns = RotationBatch::Columns;

inline void rotate_loop(Columns& c, int size) {
  using C = Columns;
  const double time_step = c.time_step;
#pragma GCC ivdep
  for (int k = 0; k < size; ++k) {
    const Vector3 momentum{c.values[C::mx][k], c.values[C::my][k], c.values[C::mz][k]};
    const Vector3 inertia{c.values[C::ix][k], c.values[C::iy][k], c.values[C::iz][k]};
    const Quaternion q =
        rotate_freely({c.values[C::qw][k], c.values[C::qx][k], c.values[C::qy][k],
                       c.values[C::qz][k]},
                      momentum, inertia, time_step);
    const Vector3 omega = angular_velocity(momentum, inertia, q);
    c.values[C::qw][k] = q.w;
    c.values[C::qx][k] = q.x;
    c.values[C::qy][k] = q.y;
    c.values[C::qz][k] = q.z;
    c.values[C::wx][k] = omega.x;
    c.values[C::wy][k] = omega.y;
    c.values[C::wz][k] = omega.z;
  }
}

ELLIPSOID_VECTOR_VERSIONS(rotate, Columns)

} // namespace

void RotationBatch::add(const Quaternion& orientation, const Vector3& momentum,
                        const Vector3& inertia) {
  using C = Columns;
  const int k = size_++;
  const auto put = [this, k](int column, double value) { columns_.values[column][k] = value; };
  put(C::qw, orientation.w);
  put(C::qx, orientation.x);
  put(C::qy, orientation.y);
  put(C::qz, orientation.z);
  put(C::mx, momentum.x);
  put(C::my, momentum.y);
  put(C::mz, momentum.z);
  put(C::ix, inertia.x);
  put(C::iy, inertia.y);
  put(C::iz, inertia.z);
}

void RotationBatch::solve(double time_step) {
  columns_.time_step = time_step;
  rotate(columns_, size_);
}

Quaternion RotationBatch::orientation(int k) const {
  using C = Columns;
  return {columns_.values[C::qw][k], columns_.values[C::qx][k], columns_.values[C::qy][k],
          columns_.values[C::qz][k]};
}

Vector3 RotationBatch::omega(int k) const {
  using C = Columns;
  return {columns_.values[C::wx][k], columns_.values[C::wy][k], columns_.values[C::wz][k]};
}

} // namespace ellipsoid
