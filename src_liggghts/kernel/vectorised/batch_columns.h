// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Loops over the columns of a batch, in space and in the plane.
//
// What is done with an item is often a long chain of operations that wait for each other (roots,
// divisions). A processor works on the next items meanwhile, as far as it can look ahead: some
// hundred instructions. So a long calculation is split into several short loops over all items.
#pragma once

#include "math/plane.h"
#include "math/vector3.h"
#include "vectorised/batch.h"

#include <cstdint>
#include <initializer_list>

namespace ellipsoid {

/// Items of a loop in one go, two of the widest vectors: loops of known length need no
/// rest. Beyond the last item a batch's columns hold numbers that mean nothing.
constexpr int loop_width = 16;
static_assert(Batch::capacity % loop_width == 0, "whole loops");

/// Calls action(k) for items from `begin` to `end` at least.
template <class Action> inline void for_items(int begin, int end, const Action& action) {
  for (int first = begin; first < end; first += loop_width) {
#pragma GCC ivdep
    for (int k = first; k < first + loop_width; ++k)
      action(k);
  }
}

/// Whether one of these numbers is not 0.
inline bool any(const double* numbers, int count) {
  std::int64_t found = 0; // as wide as the numbers
  for (int k = 0; k < count; ++k)
    found |= numbers[k] != 0.0 ? 1 : 0;
  return found != 0;
}

/// Whether these columns are 0.
template <class Rows>
inline bool all_zero(const Rows& c, std::initializer_list<int> columns, int size) {
  for (const int column : columns)
    if (any(c[column], size))
      return false;
  return true;
}

/// Numbers of item k in columns, in space.
struct InSpace {
  using Vector = Vector3;
  using AxialVector = Vector3; ///< angular velocity, torque
  using Matrix = SymmetricMatrix3;
  int k;

  template <class Rows> Matrix matrix(const Rows& c, int column) const {
    return {c[column][k],     c[column + 1][k], c[column + 2][k],
            c[column + 3][k], c[column + 4][k], c[column + 5][k]};
  }
  template <class Rows> Vector vector(const Rows& c, int column) const {
    return {c[column][k], c[column + 1][k], c[column + 2][k]};
  }
  template <class Rows> AxialVector axial_vector(const Rows& c, int column) const {
    return vector(c, column);
  }
  template <class Rows> void put(Rows& c, int column, const Vector& v) const {
    c[column][k] = v.x;
    c[column + 1][k] = v.y;
    c[column + 2][k] = v.z;
  }
  template <class Rows> void put(Rows& c, int column, const Matrix& m) const {
    c[column][k] = m.xx;
    c[column + 1][k] = m.yy;
    c[column + 2][k] = m.zz;
    c[column + 3][k] = m.xy;
    c[column + 4][k] = m.xz;
    c[column + 5][k] = m.yz;
  }
};

/// The same in the plane.
struct InPlane {
  using Vector = PlaneVector;
  using AxialVector = double; ///< along z
  using Matrix = PlaneMatrix;
  int k;

  template <class Rows> Matrix matrix(const Rows& c, int column) const {
    return {c[column][k], c[column + 1][k], c[column + 2][k], c[column + 3][k]};
  }
  template <class Rows> Vector vector(const Rows& c, int column) const {
    return {c[column][k], c[column + 1][k]};
  }
  template <class Rows> AxialVector axial_vector(const Rows& c, int column) const {
    return c[column + 2][k];
  }
  template <class Rows> void put(Rows& c, int column, const Vector& v) const {
    c[column][k] = v.x;
    c[column + 1][k] = v.y;
    c[column + 2][k] = 0.0;
  }
  template <class Rows> void put(Rows& c, int column, AxialVector z) const {
    c[column][k] = c[column + 1][k] = 0.0;
    c[column + 2][k] = z;
  }
  template <class Rows> void put(Rows& c, int column, const Matrix& m) const {
    c[column][k] = m.xx;
    c[column + 1][k] = m.yy;
    c[column + 2][k] = m.zz;
    c[column + 3][k] = m.xy;
  }
};

} // namespace ellipsoid
