// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Times that limit the time step: Rayleigh's and Hertz's, for bodies that also turn when they
// collide.
#pragma once

#include "math/vector3.h"
#include "multisphere/multisphere_contact.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid {

/// Time in which a Rayleigh wave runs half around a sphere of this radius: pi r sqrt(rho/G) /
/// (0.1631 nu + 0.8766); Thornton and Randall 1988, in the form of Li, Xu and Thornton, Powder
/// Technology 160 (2005) 219.
inline double rayleigh_time(double radius, double density, double shear_modulus,
                            double poissons_ratio) {
  return M_PI * radius * std::sqrt(density / shear_modulus) / (0.1631 * poissons_ratio + 0.8766);
}

/// Duration of an elastic collision, 2.87 (m*^2 / (R E*^2 v))^(1/5); Johnson, Contact Mechanics
/// (1985), eq. 11.24. @param[in] mass2_over_radius m*^2/R, m* the reduced mass at the contact
/// (mass^2/length)
inline double hertz_time(double mass2_over_radius, double effective_modulus, double speed) {
  return 2.87 * std::pow(mass2_over_radius / (effective_modulus * effective_modulus * speed), 0.2);
}

/// m*^2/R of a body that hits its like, both with the point at which they touch: R is half the
/// radius of curvature there, 1/m* twice the mobility along the normal, 1/m + (r x n).I^-1.(r x n).
inline double mass2_over_radius(double curvature, double mobility) {
  return 0.5 * curvature / (mobility * mobility);
}

/// The same for the point with normal n of an ellipsoid: 1/R of (19) for two equal, aligned
/// curvatures.
/// @param[in] p squares of the normal's components (body frame), sum 1
inline double mass2_over_radius(const Vector3& semiaxes, double mass, const Vector3& inertia,
                                const Vector3& p) {
  const double aa = semiaxes.x * semiaxes.x, bb = semiaxes.y * semiaxes.y,
               cc = semiaxes.z * semiaxes.z;
  const double s2 = aa * p.x + bb * p.y + cc * p.z; // square of the support
  const double arms = (bb - cc) * (bb - cc) * p.y * p.z / inertia.x +
                      (cc - aa) * (cc - aa) * p.z * p.x / inertia.y +
                      (aa - bb) * (aa - bb) * p.x * p.y / inertia.z;
  const double curvature = s2 / (semiaxes.x * semiaxes.y * semiaxes.z); // root of Gauss's
  return mass2_over_radius(curvature, 1.0 / mass + arms / s2);
}

/// The smallest value over all points of an ellipsoid: where it is stiffest and lightest at once.
/// Pairs of unlike points or bodies lie between the values of the two: with k >= C u^2 for both,
/// (k1 + k2) / (u1 + u2)^2 >= C/2.
inline double smallest_mass2_over_radius(const Vector3& semiaxes, double mass,
                                         const Vector3& inertia) {
  constexpr int parts = 16; // of the triangle of p; then the best point is refined
  constexpr double resolution = 1e-5;
  double best = HUGE_VAL;
  Vector3 at;
  const auto visit = [&](double x, double y) {
    const Vector3 p{x, y, 1.0 - x - y};
    if (p.x < 0.0 || p.y < 0.0 || p.z < -1e-15)
      return;
    const double value = mass2_over_radius(semiaxes, mass, inertia, p);
    if (value < best) {
      best = value;
      at = p;
    }
  };
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j)
      visit(static_cast<double>(i) / parts, static_cast<double>(j) / parts);
  for (double step = 0.5 / parts; step > resolution; step *= 0.5)
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        visit(at.x + dx * step, at.y + dy * step);
  return best;
}

/// The same for a chain of spheres, each touched from the side.
/// @param[in] inertia_across principal moment across the chain
inline double smallest_mass2_over_radius(const SphereChain& chain, double scale, double mass,
                                         double inertia_across) {
  double best = HUGE_VAL;
  for (int k = 0; k < chain.count(); ++k) {
    const double arm = scale * chain.centre(k);
    best = std::min(best, mass2_over_radius(1.0 / (scale * chain.radius(k)),
                                            1.0 / mass + arm * arm / inertia_across));
  }
  return best;
}

} // namespace ellipsoid
