// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "shape_batch.h"

#include "vector_versions.h"

namespace ellipsoid {

namespace {

inline void make_shapes_loop(ShapeBatch::Columns& c, int size) {
  using C = ShapeBatch::Columns;
#pragma GCC ivdep
  for (int k = 0; k < size; ++k) {
    const EllipsoidShape shape =
        make_shape({c.in[C::a][k], c.in[C::b][k], c.in[C::c][k]},
                   {c.in[C::qw][k], c.in[C::qx][k], c.in[C::qy][k], c.in[C::qz][k]});
    c.out[C::xx][k] = shape.a_matrix.xx;
    c.out[C::yy][k] = shape.a_matrix.yy;
    c.out[C::zz][k] = shape.a_matrix.zz;
    c.out[C::xy][k] = shape.a_matrix.xy;
    c.out[C::xz][k] = shape.a_matrix.xz;
    c.out[C::yz][k] = shape.a_matrix.yz;
    c.out[C::product][k] = shape.axes_product;
    c.out[C::smallest_radius][k] = shape.smallest_curvature_radius;
  }
}

ELLIPSOID_VECTOR_VERSIONS(make_shapes, ShapeBatch::Columns)

} // namespace

void ShapeBatch::solve() { make_shapes(columns_, size()); }

} // namespace ellipsoid
