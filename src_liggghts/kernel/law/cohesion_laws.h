// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Cohesion laws, of the same form as normal_laws.h: what pulls the two bodies together.
#pragma once

#include <cmath>

namespace ellipsoid {

/// Radius of curvature of a plane that a sphere of radius R touches: so large that it makes no
/// difference to R, and not so large that products of four leave the range of numbers (length).
constexpr double plane_radius(double radius) { return 1e18 * radius; }

struct CohesiveContact {
  double overlap;            ///< h (length)
  double reduced_radius;     ///< R (length)
  double radius_i, radius_j; ///< Gaussian radii of curvature (length)
  bool with_wall;            ///< of one body with a wall; radius_j: see plane_radius()
};

/// The host's simplified Johnson-Kendall-Roberts model: an energy density times the area of the
/// circle in which two spheres with the radii of curvature, scaled to the contact's R, intersect.
struct Sjkr {
  static constexpr const char* style = "sjkr";
  enum { energy_density };
  static constexpr const char* parameters[] = {"cohEnergyDens"};

  template <class Parameters> static double pull(const CohesiveContact& c, const Parameters& p) {
    const double scale = c.reduced_radius * (c.radius_i + c.radius_j) / (c.radius_i * c.radius_j);
    const double radius_i = scale * c.radius_i, radius_j = scale * c.radius_j, h = c.overlap;
    const double distance = radius_i + radius_j - h;
    return p(energy_density) * 0.25 * M_PI * h * (2.0 * radius_i - h) * (2.0 * radius_j - h) *
           (2.0 * (radius_i + radius_j) - h) / (distance * distance);
  }
};

/// The same with twice the area of Hertz's contact, at walls with that area.
struct Sjkr2 {
  static constexpr const char* style = "sjkr2";
  enum { energy_density };
  static constexpr const char* parameters[] = {"cohEnergyDens"};

  template <class Parameters> static double pull(const CohesiveContact& c, const Parameters& p) {
    return p(energy_density) * (c.with_wall ? 2.0 : 4.0) * M_PI * c.reduced_radius * c.overlap;
  }
};

} // namespace ellipsoid
