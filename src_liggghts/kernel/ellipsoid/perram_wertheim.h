// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Two ellipsoids, scaled about their centres by one common factor until they just touch: Perram and
// Wertheim 1985, J. Comput. Phys. 58, 409. The factor's square is the maximum over 0 < lambda < 1
// of lambda (1 - lambda) d^T G^-1 d with G = (1 - lambda) A_i + lambda A_j, which is concave; its
// derivative has the sign of (1 - lambda) s_i(n) - lambda s_j(n) at n ~ G^-1 d.
#pragma once

#include "math/vector3.h"

namespace ellipsoid {

/// G at one lambda, and y = adj(G) d, which is det(G) G^-1 d: of the direction n.
struct PerramWertheim {
  SymmetricMatrix3 g, cofactors;
  Vector3 y;

  /// @param[in] i, j the bodies' matrices A (length^2), @param[in] d from i's centre to j's
  PerramWertheim(const SymmetricMatrix3& i, const SymmetricMatrix3& j, const Vector3& d,
                 double lambda)
      : g((1.0 - lambda) * i + lambda * j), cofactors(adjugate(g)), y(cofactors * d) {}
  double determinant() const {
    return g.xx * cofactors.xx + g.xy * cofactors.xy + g.xz * cofactors.xz;
  }
};

/// Where the derivative would vanish if s_i and s_j stayed as they are.
inline double next_lambda(double support_i, double support_j) {
  return support_i / (support_i + support_j);
}

} // namespace ellipsoid
