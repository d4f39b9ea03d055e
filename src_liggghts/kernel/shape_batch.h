// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The shapes of many turned ellipsoids at once: make_shape() in a loop that the compiler turns into
// vector instructions. The results are those of the function, bit for bit.
#pragma once

#include "batch.h"
#include "ellipsoid_contact.h"

namespace ellipsoid {

class ShapeBatch : public Batch {
 public:
  /// @param[in] semiaxes    a, b, c along the body's x, y, z (length, > 0)
  /// @param[in] orientation unit quaternion, body to space
  void add(const Vector3& semiaxes, const Quaternion& orientation) {
    using C = Columns;
    const int k = next();
    columns_.in[C::a][k] = semiaxes.x;
    columns_.in[C::b][k] = semiaxes.y;
    columns_.in[C::c][k] = semiaxes.z;
    columns_.in[C::qw][k] = orientation.w;
    columns_.in[C::qx][k] = orientation.x;
    columns_.in[C::qy][k] = orientation.y;
    columns_.in[C::qz][k] = orientation.z;
  }

  /// Makes all shapes.
  void solve();

  /// Of ellipsoid k. Copied number by number: see contact_batch.h.
  void store(int k, EllipsoidShape& shape) const {
    using C = Columns;
    shape.a_matrix.xx = columns_.out[C::xx][k];
    shape.a_matrix.yy = columns_.out[C::yy][k];
    shape.a_matrix.zz = columns_.out[C::zz][k];
    shape.a_matrix.xy = columns_.out[C::xy][k];
    shape.a_matrix.xz = columns_.out[C::xz][k];
    shape.a_matrix.yz = columns_.out[C::yz][k];
    shape.axes_product = columns_.out[C::product][k];
    shape.smallest_curvature_radius = columns_.out[C::smallest_radius][k];
  }

  /// Columns of numbers, one per ellipsoid.
  struct Columns {
    enum Input { a, b, c, qw, qx, qy, qz, input_count };
    enum Result { xx, yy, zz, xy, xz, yz, product, smallest_radius, result_count };
    alignas(64) double in[input_count][column_length];
    alignas(64) double out[result_count][column_length];
  };

 private:
  Columns columns_;
};

} // namespace ellipsoid
