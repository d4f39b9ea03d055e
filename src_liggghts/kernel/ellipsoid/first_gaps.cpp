// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid/first_gaps.h"

#include "vectorised/vector_versions.h"

#include <cmath>

namespace ellipsoid {

namespace {

using Columns = FirstGaps::Columns;

inline void find_all_loop(Columns& c, int size) {
  for_items(0, size, [&c](int k) {
    const InSpace at{k};
    const SymmetricMatrix3 a_i = at.matrix(c.in, Columns::axx_i),
                           a_j = at.matrix(c.in, Columns::axx_j);
    const Vector3 distance = at.vector(c.in, Columns::dx);
    const Vector3 n = normalized(adjugate(a_i + a_j) * distance);
    at.put(c.out, Columns::nx, n);
    c.out[Columns::distance][k] =
        dot(n, distance) - (std::sqrt(dot(n, a_i * n)) + std::sqrt(dot(n, a_j * n)));
  });
}

} // namespace

void FirstGaps::find() {
  WidestVersion<find_all_loop>::run(columns_, filled_up(columns_.in, size(), loop_width));
}

} // namespace ellipsoid
