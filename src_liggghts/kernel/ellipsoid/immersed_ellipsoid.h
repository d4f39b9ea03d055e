// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The part of an ellipsoid below a plane: what is immersed in a liquid at rest.
#pragma once

#include "ellipsoid/ellipsoid_properties.h"
#include "math/vector3.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid {

/// Volume (length^3) and centroid, relative to the ellipsoid's centre (length), of its part below a
/// plane.
struct ImmersedPart {
  double volume = 0.0;
  Vector3 centroid;
};

/// The ellipsoid is the affine image of a ball, and so is the part of it: a segment of the ball. Of
/// the unit ball, what lies below the height t has the volume pi/3 (1 + t)^2 (2 - t) and its
/// centroid at the height -3/4 (1 - t)^2 / (2 - t) (Harris, Stocker: Handbook of Mathematics and
/// Computational Science, 1998, section 4.8.4, spherical segment).
/// @param[in] up    unit normal of the plane (space frame)
/// @param[in] depth of the centre below the plane (length, negative above it)
inline ImmersedPart immersed_part(const Vector3& semiaxes, const Quaternion& orientation,
                                  const Vector3& up, double depth) {
  const Rotation3 r = rotation(orientation);
  const Vector3 n = r.to_body(up);
  const Vector3 stretched{semiaxes.x * semiaxes.x * n.x, semiaxes.y * semiaxes.y * n.y,
                          semiaxes.z * semiaxes.z * n.z};
  const double half_height = std::sqrt(dot(n, stretched));
  const double t = std::clamp(depth / half_height, -1.0, 1.0);
  const double share = 0.25 * (1.0 + t) * (1.0 + t) * (2.0 - t);
  const double below = 0.75 * (1.0 - t) * (1.0 - t) / (2.0 - t);
  return {share * volume(semiaxes), (-below / half_height) * r.to_space(stretched)};
}

} // namespace ellipsoid
