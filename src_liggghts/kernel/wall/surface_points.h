// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Points of an ellipsoid, or of its shadow, nearest to and farthest from a given point.
#pragma once

#include "ellipsoid/ellipsoid_contact.h"

#include <array>

namespace ellipsoid {

/// Outward unit normal at the surface point nearest to `point`, inside or outside, both in
/// principal axes. Unique but on the medial axis inside (there: the side of positive coordinates);
/// each component has the sign of the point's. Exact at any depth.
/// @param[in] semiaxes > 0 (length)
Vector3 nearest_normal(const Vector3& semiaxes, const Vector3& point);

/// The shadow of an ellipsoid on a plane: an ellipse about the same centre.
struct Shadow {
  Vector3 major, minor;    ///< unit, normal to the direction of projection
  double a = 0.0, b = 0.0; ///< semi-axes, a >= b (length)
};

/// @param[in] direction unit, of projection
Shadow shadow_along(const EllipsoidShape& shape, const Vector3& direction);

/// Outward unit normal of the shadow at its point nearest to the shadow of `point`.
Vector3 nearest_normal(const Shadow& shadow, const Vector3& point);

/// Unit vectors from the shadow of `point` to those points of the shadow's edge where the distance
/// from it has a maximum: the edge's outward normals there. One or two; the farthest comes first.
struct FarthestNormals {
  std::array<Vector3, 2> normal;
  int count = 0;
};
FarthestNormals farthest_normals(const Shadow& shadow, const Vector3& point);

} // namespace ellipsoid
