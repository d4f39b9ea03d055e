// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid/shape_batch.h"

#include "vectorised/vector_versions.h"

#include <algorithm>

namespace ellipsoid {

namespace {

constexpr int block = 64;

/// Columns of numbers, one row per ellipsoid of a block.
using Columns = double[8][block];

inline void make_columns(const double* axes, const double* q, int count, Columns& columns) {
#pragma GCC ivdep
  for (int k = 0; k < count; ++k) {
    const EllipsoidShape shape = make_shape({axes[3 * k], axes[3 * k + 1], axes[3 * k + 2]},
                                            {q[4 * k], q[4 * k + 1], q[4 * k + 2], q[4 * k + 3]});
    columns[0][k] = shape.a_matrix.xx;
    columns[1][k] = shape.a_matrix.yy;
    columns[2][k] = shape.a_matrix.zz;
    columns[3][k] = shape.a_matrix.xy;
    columns[4][k] = shape.a_matrix.xz;
    columns[5][k] = shape.a_matrix.yz;
    columns[6][k] = shape.axes_product;
    columns[7][k] = shape.smallest_curvature_radius;
  }
}

inline void make_all_loop(ShapeRows& rows, int count) {
  alignas(64) Columns columns;
  for (int first = 0; first < count; first += block) {
    const int size = std::min(block, count - first);
    make_columns(rows.semiaxes + 3 * static_cast<std::ptrdiff_t>(first),
                 rows.orientations + 4 * static_cast<std::ptrdiff_t>(first), size, columns);
    EllipsoidShape* shapes = rows.shapes + first;
    for (int k = 0; k < size; ++k)
      shapes[k] = {{columns[0][k], columns[1][k], columns[2][k], columns[3][k], columns[4][k],
                    columns[5][k]},
                   columns[6][k],
                   columns[7][k]};
  }
}

} // namespace

void make_shapes(ShapeRows rows, int count) { WidestVersion<make_all_loop>::run(rows, count); }

} // namespace ellipsoid
