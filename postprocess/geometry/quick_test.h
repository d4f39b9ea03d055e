// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Whether two ellipsoids touch, as far as a test or two tell before any search; many pairs at once.
#pragma once

#include "ellipsoid/ellipsoid_contact.h"
#include "ellipsoid/perram_wertheim.h"
#include "vectorised/batch.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {

/// What one test of two ellipsoids tells.
struct QuickTest {
  bool are_apart = false;   ///< proved by `normal`
  bool touch = false;       ///< proved by a point inside both
  Vector3 normal;           ///< from i to j, any length: near the contact's
  double next_lambda = 0.5; ///< nearer to the maximum of the function
};

/// The function of Perram and Wertheim at one lambda (perram_wertheim.h): with y = G^-1 d the point
/// x_i + (1 - lambda) A_i y lies at the levels
/// (1 - lambda)^2 s_i(y)^2 and lambda^2 s_j(y)^2 of the bodies (1: surface), and y is the normal
/// of a plane that separates them when s_i(y) + s_j(y) < y.d.
/// @param[in] i, j the bodies' matrices A (length^2), @param[in] d from i's centre to j's (length)
inline QuickTest quick_test(const SymmetricMatrix3& i, const SymmetricMatrix3& j, const Vector3& d,
                            double lambda) {
  // far above the rounding of the most slender bodies that are read (aspect ratio 1e4)
  constexpr double well_inside = 1.0 - 1.0e-6;
  const PerramWertheim at(i, j, d, lambda);
  const Vector3& y = at.y; // times the determinant
  const double s_i = std::sqrt(dot(y, i * y)), s_j = std::sqrt(dot(y, j * y));
  const double determinant = at.determinant();
  const double sum = s_i + s_j;
  const bool touch = std::max((1.0 - lambda) * s_i, lambda * s_j) < well_inside * determinant;
  const double next = sum > 0.0 ? next_lambda(s_i, s_j) : lambda;
  return {sum < dot(y, d), touch, {y.x, y.y, y.z}, next}; // by numbers: else no vector loop
}

/// Two tests of each of many pairs. All take the same operations: the compiler turns the loop into
/// vector instructions.
class QuickTestBatch : public Batch {
 public:
  /// @param[in] distance from i's centre to j's (length)
  void add(const EllipsoidShape& i, const EllipsoidShape& j, const Vector3& distance);
  void solve();

  bool are_apart(int k) const { return columns_.out[Columns::is_apart][k] != 0.0; }
  bool touch(int k) const { return columns_.out[Columns::is_touching][k] != 0.0; }
  Vector3 distance(int k) const { return vector(columns_.in, Columns::dx, k); }
  /// Unit vector from i to j near the contact's normal; for pairs that are not apart.
  Vector3 normal(int k) const { return vector(columns_.out, Columns::nx, k); }

  /// Columns of numbers, one per pair.
  struct Columns {
    enum Input { a_i, a_j = 6, dx = 12, dy, dz, input_count };
    enum Result { nx, ny, nz, is_apart, is_touching, result_count };
    alignas(64) double in[input_count][column_length];
    alignas(64) double out[result_count][column_length];
  };

 private:
  static Vector3 vector(const double (*columns)[column_length], int first, int k) {
    return {columns[first][k], columns[first + 1][k], columns[first + 2][k]};
  }

  Columns columns_;
};

inline void QuickTestBatch::add(const EllipsoidShape& i, const EllipsoidShape& j,
                                const Vector3& distance) {
  const int k = next();
  const auto put_matrix = [this, k](int column, const SymmetricMatrix3& a) {
    columns_.in[column][k] = a.xx;
    columns_.in[column + 1][k] = a.yy;
    columns_.in[column + 2][k] = a.zz;
    columns_.in[column + 3][k] = a.xy;
    columns_.in[column + 4][k] = a.xz;
    columns_.in[column + 5][k] = a.yz;
  };
  put_matrix(Columns::a_i, i.a_matrix);
  put_matrix(Columns::a_j, j.a_matrix);
  columns_.in[Columns::dx][k] = distance.x;
  columns_.in[Columns::dy][k] = distance.y;
  columns_.in[Columns::dz][k] = distance.z;
}

} // namespace ellipsoid::post
