// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Volume, surface and inertia of an ellipsoid with semi-axes (a, b, c) along the body's x, y, z.
#pragma once

#include "math/vector3.h"

#include <algorithm>

namespace ellipsoid {

/// 4/3 pi a b c (length^3); Markauskas et al. 2010, eq. (2).
inline double volume(const Vector3& semiaxes) {
  return 4.0 / 3.0 * M_PI * semiaxes.x * semiaxes.y * semiaxes.z;
}

/// Radius of the bounding sphere about the centre (length).
inline double bounding_radius(const Vector3& semiaxes) {
  return std::max({semiaxes.x, semiaxes.y, semiaxes.z});
}

/// Principal moments (mass length^2) of a homogeneous ellipsoid: m/5 (b^2 + c^2), ...
inline Vector3 principal_moments(const Vector3& semiaxes, double mass) {
  const double aa = semiaxes.x * semiaxes.x, bb = semiaxes.y * semiaxes.y,
               cc = semiaxes.z * semiaxes.z;
  return {0.2 * mass * (bb + cc), 0.2 * mass * (aa + cc), 0.2 * mass * (aa + bb)};
}

/// Surface area (length^2), exact by incomplete elliptic integrals (Legendre's form).
inline double surface_area(const Vector3& semiaxes) {
  double axes[3] = {semiaxes.x, semiaxes.y, semiaxes.z};
  std::sort(axes, axes + 3);
  const double c = axes[0], b = axes[1], a = axes[2];
  const double ratio = c / a, sine2 = 1.0 - ratio * ratio;
  if (sine2 < 1e-12) // a sphere: the formula below is 0/0
    return 4.0 * M_PI * a * a;
  const double sine = std::sqrt(sine2), angle = std::acos(ratio);
  const double modulus2 = a * a * (b * b - c * c) / (b * b * (a * a - c * c));
  const double modulus = std::sqrt(std::clamp(modulus2, 0.0, 1.0));
  return 2.0 * M_PI *
         (c * c + a * b / sine *
                      (std::ellint_2(modulus, angle) * sine2 +
                       std::ellint_1(modulus, angle) * ratio * ratio));
}

} // namespace ellipsoid
