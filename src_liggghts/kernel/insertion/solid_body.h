// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A body that takes up room: a smooth ellipsoid or a body of spheres, where it is in space. What
// insertion asks of it: whether it overlaps another one, and whether it lies wholly in a block,
// ball or cylinder.
#pragma once

#include "ellipsoid/ellipsoid_contact.h"
#include "math/vector3.h"
#include "multisphere/multisphere_contact.h"

#include <array>

namespace ellipsoid {

struct SolidBody {
  Vector3 centre;                ///< (length)
  double bounding_radius = 0.0;  ///< about the centre (length)
  double inscribed_radius = 0.0; ///< of a ball about the centre within the body; 0: none (length)
  EllipsoidShape shape;          ///< of a smooth body
  MultispherePose spheres;       ///< of one made of spheres; its `body` is null for a smooth body

  bool is_smooth() const { return spheres.body == nullptr; }
};

/// @param[in] orientation unit quaternion, body to space
SolidBody smooth_body(const Vector3& centre, const Vector3& semiaxes,
                      const Quaternion& orientation);
SolidBody multisphere_body(const Vector3& centre, const MultispherePose& pose);

/// The ball of `inscribed_radius` > 0: where it has no room the body has none, however it is
/// turned.
SolidBody inscribed_ball(const SolidBody& body);

/// Whether two bodies have a point in common, exactly.
bool overlap(const SolidBody& i, const SolidBody& j);

/// @param[in] low, high corners (length)
bool is_inside_block(const SolidBody& body, const std::array<double, 3>& low,
                     const std::array<double, 3>& high);
bool is_inside_ball(const SolidBody& body, const Vector3& centre, double radius);
/// @param[in] axis 0, 1, 2: parallel to x, y, z; @param[in] centre a point of the axis
/// @param[in] low, high ends along the axis (length)
bool is_inside_cylinder(const SolidBody& body, int axis, const Vector3& centre, double radius,
                        double low, double high);

/// Square of the largest distance from the origin to a point of the ellipsoid (N = 3) or ellipse
/// (N = 2) about `centre` whose axes are parallel to the coordinates. Never too small.
/// @param[in] squared semi-axes squared (length^2), @param[in] centre (length)
template <std::size_t N>
double farthest_squared_distance(const std::array<double, N>& squared,
                                 const std::array<double, N>& centre);

} // namespace ellipsoid
