// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "rotation_batch.h"

#include "vector_versions.h"

namespace ellipsoid {

namespace {

inline void rotate_loop(RotationBatch::Columns& c, int size) {
  using C = RotationBatch::Columns;
  const double time_step = c.time_step;
  auto& v = c.values;
#pragma GCC ivdep
  for (int k = 0; k < size; ++k) {
    const Rotating after = rotate_freely({v[C::qw][k], v[C::qx][k], v[C::qy][k], v[C::qz][k]},
                                         {v[C::mx][k], v[C::my][k], v[C::mz][k]},
                                         {v[C::ix][k], v[C::iy][k], v[C::iz][k]}, time_step);
    v[C::qw][k] = after.orientation.w;
    v[C::qx][k] = after.orientation.x;
    v[C::qy][k] = after.orientation.y;
    v[C::qz][k] = after.orientation.z;
    v[C::wx][k] = after.omega.x;
    v[C::wy][k] = after.omega.y;
    v[C::wz][k] = after.omega.z;
  }
}

ELLIPSOID_VECTOR_VERSIONS(rotate, RotationBatch::Columns)

} // namespace

void RotationBatch::solve(double time_step) {
  columns_.time_step = time_step;
  rotate(columns_, size());
}

} // namespace ellipsoid
