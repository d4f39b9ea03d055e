// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "rotation_batch.h"

#include "vector_versions.h"

namespace ellipsoid {

namespace {

template <class Columns> Quaternion quaternion_of(const Columns& c, int k) {
  return {c.values[Columns::qw][k], c.values[Columns::qx][k], c.values[Columns::qy][k],
          c.values[Columns::qz][k]};
}

template <class Columns> void put(Columns& c, const Quaternion& q, int k) {
  c.values[Columns::qw][k] = q.w;
  c.values[Columns::qx][k] = q.x;
  c.values[Columns::qy][k] = q.y;
  c.values[Columns::qz][k] = q.z;
}

template <class Columns> Vector3 inertia_of(const Columns& c, int k) {
  return {c.values[Columns::ix][k], c.values[Columns::iy][k], c.values[Columns::iz][k]};
}

template <class Columns> void put_inertia(Columns& c, const Vector3& inertia, int k) {
  c.values[Columns::ix][k] = inertia.x;
  c.values[Columns::iy][k] = inertia.y;
  c.values[Columns::iz][k] = inertia.z;
}

inline void rotate_loop(RotationBatch::Columns& c, int size) {
  using C = RotationBatch::Columns;
  const double time_step = c.time_step;
#pragma GCC ivdep
  for (int k = 0; k < size; ++k) {
    const Vector3 momentum{c.values[C::mx][k], c.values[C::my][k], c.values[C::mz][k]};
    const Vector3 inertia = inertia_of(c, k);
    const Quaternion q = rotate_freely(quaternion_of(c, k), momentum, inertia, time_step);
    const Vector3 omega = angular_velocity(momentum, inertia, q);
    put(c, q, k);
    c.values[C::wx][k] = omega.x;
    c.values[C::wy][k] = omega.y;
    c.values[C::wz][k] = omega.z;
  }
}

ELLIPSOID_VECTOR_VERSIONS(rotate, RotationBatch::Columns)

} // namespace

void RotationBatch::add(const Quaternion& orientation, const Vector3& momentum,
                        const Vector3& inertia) {
  const int k = next();
  put(columns_, orientation, k);
  columns_.values[Columns::mx][k] = momentum.x;
  columns_.values[Columns::my][k] = momentum.y;
  columns_.values[Columns::mz][k] = momentum.z;
  put_inertia(columns_, inertia, k);
}

void RotationBatch::solve(double time_step) {
  columns_.time_step = time_step;
  rotate(columns_, size());
}

Quaternion RotationBatch::orientation(int k) const { return quaternion_of(columns_, k); }

Vector3 RotationBatch::omega(int k) const {
  using C = Columns;
  return {columns_.values[C::wx][k], columns_.values[C::wy][k], columns_.values[C::wz][k]};
}

} // namespace ellipsoid
