// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "vector3.h"

namespace ellipsoid {

/// Two unit vectors that make a right-handed frame with the unit vector n; no square root and
/// no branch but a sign (Duff et al. 2017, J. Comput. Graph. Tech. 6(1), listing 3).
struct TangentFrame {
  Vector3 first, second;

  explicit TangentFrame(const Vector3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double p = -1.0 / (sign + n.z);
    const double q = n.x * n.y * p;
    first = {1.0 + sign * n.x * n.x * p, sign * q, -sign * n.x};
    second = {q, sign + n.y * n.y * p, -n.y};
  }
};

} // namespace ellipsoid
