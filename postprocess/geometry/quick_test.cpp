// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "quick_test.h"

#include "vectorised/vector_versions.h"

namespace ellipsoid::post {
namespace {

using Columns = QuickTestBatch::Columns;

inline void test_pair(Columns& columns, int k) {
  using C = Columns;
  const auto matrix = [&columns, k](int column) {
    return SymmetricMatrix3{columns.in[column][k],     columns.in[column + 1][k],
                            columns.in[column + 2][k], columns.in[column + 3][k],
                            columns.in[column + 4][k], columns.in[column + 5][k]};
  };
  const SymmetricMatrix3 i = matrix(C::a_i), j = matrix(C::a_j);
  const Vector3 d{columns.in[C::dx][k], columns.in[C::dy][k], columns.in[C::dz][k]};
  const QuickTest first = quick_test(i, j, d, 0.5);
  const QuickTest second = quick_test(i, j, d, first.next_lambda);
  const Vector3& y = second.normal;
  const double length = std::sqrt(dot(y, y));
  const bool has_length = length > 0.0;
  const double scale = 1.0 / (has_length ? length : 1.0);
  columns.out[C::nx][k] = has_length ? scale * y.x : 1.0;
  columns.out[C::ny][k] = scale * y.y;
  columns.out[C::nz][k] = scale * y.z;
  columns.out[C::is_apart][k] = (first.are_apart | second.are_apart) ? 1.0 : 0.0;
  columns.out[C::is_touching][k] = (first.touch | second.touch) ? 1.0 : 0.0;
}

inline void test_loop(Columns& columns, int size) {
#pragma GCC ivdep
  for (int k = 0; k < size; ++k)
    test_pair(columns, k);
}

} // namespace

void QuickTestBatch::solve() {
  WidestVersion<test_loop>::run(columns_, filled_up(columns_.in, size()));
}

} // namespace ellipsoid::post
