// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The placing of spheres for each spacing: half chains (middle sphere first, then to +x).
// Used by multisphere_template.cpp; other code calls make_multisphere().
#pragma once

#include "multisphere/multisphere_template.h"

#include <vector>

namespace ellipsoid {

/// Middle sphere (centre 0) and the n spheres to its right: N = 2n + 1.
struct HalfChain {
  std::vector<double> centres, radii; ///< n + 1 values each (length)
};

/// The whole chain, from -x to +x.
MultisphereTemplate mirrored(double a, double b, SphereSpacing spacing, const HalfChain& half);

/// Distance of the axis point (x, 0) from the ellipse, |x| <= a: radius of the inscribed sphere,
/// eq. (4) between the vertices' centres of curvature, a - |x| beyond them (length).
double inscribed_radius(double a, double b, double x);

/// Eqs. (3) to (8); n >= 1.
HalfChain paper_half_chain(double a, double b, int n);

/// Equal-ripple chain: crests stand out of the ellipse by the same length by which notches and
/// tips stay below it; n >= 1. With few spheres at a high aspect ratio neighbours may only touch.
HalfChain minimax_outline_half_chain(double a, double b, int n);

/// Minimum of the area between outline and ellipse; n >= 1. If the equal-ripple chain, where the
/// search starts, does not overlap, that chain is returned.
/// @throws std::invalid_argument no convergence (not seen for N up to 999, aspect ratios 1.0001 to
/// 50)
HalfChain minimax_area_half_chain(double a, double b, int n);

/// Whether every sphere overlaps its neighbour; touching does not count.
bool neighbours_overlap(const HalfChain& half);

/// Abscissa of the plane in which two spheres of the chain cut each other (radical plane).
double cutting_plane(double centre_left, double radius_left, double centre_right,
                     double radius_right);

/// Root of `f` in [low, high] with f(low) and f(high) of opposite sign (or zero), to the last bit,
/// by bisection: O(60) calls, cannot fail.
template <class Function> double bisect(const Function& f, double low, double high) {
  const bool low_is_positive = f(low) > 0.0;
  for (;;) {
    const double middle = low + 0.5 * (high - low);
    if (!(middle > low && middle < high))
      return middle;
    ((f(middle) > 0.0) == low_is_positive ? low : high) = middle;
  }
}

} // namespace ellipsoid
