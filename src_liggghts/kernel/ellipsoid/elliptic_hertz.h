// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Hertz's solution for contacts whose curvatures differ in two directions: the contact area is an
// ellipse. (19) replaces it by a circle.
#pragma once

#include <cmath>

namespace ellipsoid {

/// Gap of two bodies at a contact, before they are pressed together: A x^2 + B y^2 in the tangent
/// plane, A <= B (1/length). For two spheres A = B = 1 / (2 R).
struct RelativeCurvature {
  double smaller = 0.0; ///< A
  double larger = 0.0;  ///< B
};

/// R of the circle that (19) puts in the place of the ellipse (length).
inline double circle_radius(const RelativeCurvature& curvature) {
  return 0.5 / std::sqrt(curvature.smaller * curvature.larger); // Markauskas et al. 2010, eq. 19
}

struct EllipticContact {
  double effective_radius = 0.0; ///< R that makes F = 4/3 E* sqrt(R) h^(3/2) exact (length)
  double area_per_overlap = 0.0; ///< contact area over h (length)
  double axis_ratio = 1.0;       ///< smaller over larger semi-axis of the contact ellipse
};

/// @param[in] curvature 0 < A <= B, finite
EllipticContact elliptic_hertz(const RelativeCurvature& curvature);

/// Complete elliptic integrals of the modulus e, e^2 = 1 - k^2, 0 < k <= 1.
struct EllipticIntegrals {
  double first;  ///< K
  double second; ///< D = (K - E) / e^2
};

EllipticIntegrals elliptic_integrals(double k);

} // namespace ellipsoid
