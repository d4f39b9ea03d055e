// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Simple bodies that a body lies within, about its centre and along its axes: the broad phase of
// the contact search asks these.
#pragma once

#include "math/vector3.h"

#include <algorithm>
#include <vector>

namespace ellipsoid {

/// Largest |dh/d angle| of the support function h = sqrt(a^2 cos^2 + c^2 sin^2): a - c (length).
inline double turning_radius(double a, double b, double c) {
  return std::max(std::max(a, b), c) - std::min(std::min(a, b), c);
}

struct BodyBounds {
  Vector3 semiaxes;            ///< of an ellipsoid (length)
  int capsule_axis = 0;        ///< of a capsule, a sphere swept along an axis of the body: 0 to 2
  double half_length = 0.0;    ///< of the capsule's segment (length)
  double capsule_radius = 0.0; ///< (length)
  double turning_radius = 0.0; ///< how fast its reach changes at most as it turns (length / rad)
};

/// Bounds of an ellipsoid: itself, and a capsule along its longest axis.
BodyBounds bounds_of_ellipsoid(const Vector3& semiaxes);

/// Bounds of spheres: the ellipsoid has the ratios of the spheres' reach along x, y and z, and is
/// as large as the spheres need; the capsule lies along the largest reach, as thin as they allow.
/// @param[in] centres, radii as many radii as centres, positive (length)
BodyBounds bounds_of_spheres(const std::vector<Vector3>& centres, const std::vector<double>& radii);

/// Of a body that is so many times as large.
BodyBounds scaled(const BodyBounds& bounds, double factor);

/// By what factor an ellipsoid has to be enlarged to hold a ball, to 1e-12 from above. The largest
/// of the squares ((c + r n)_i / a_i)^2 over unit n has a dual without a gap (a quadratic form on a
/// sphere: S-lemma), whose one multiplier is bisected.
double enlargement_for_ball(const Vector3& semiaxes, const Vector3& centre, double radius);

} // namespace ellipsoid
