// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contact with an infinitely long circular cylinder as a wall, from inside or outside.
//
// Seen along the cylinder's axis an ellipsoid is an ellipse, its shadow, with support function s.
// With m from the body's centre to the axis (normal to it) and a unit normal n across the axis,
//   inside:  overlap = s(n) - n.m - R at the maxima of s(n) - n.m, the distance from the axis;
//            there may be two, at the tips of a long body: two contacts;
//   outside: overlap = s(n) - n.m + R at its minimum, as for two convex bodies.
// The particle's centre tells which side is meant. Conventions: ellipsoid_contact.h.
//
// The reduced radius is that of (19) with the relative curvature of body and wall: the wall has the
// curvature -1/R (inside) or 1/R (outside) around the axis and none along it. With W the tensor of
// the body's radii of curvature, t the tangent around the axis and w = t.W.t,
//   det(W^-1 -+ t t^T / R) = det(W^-1) (1 -+ w / R)
// (matrix determinant lemma), so R of (19) is that at a plane divided by sqrt(1 -+ w / R).
#pragma once

#include "multisphere/multisphere_contact.h"
#include "wall/wall_contact.h"

#include <vector>

namespace ellipsoid {

struct Cylinder {
  Vector3 centre;      ///< any point of the axis, relative to the particle's centre (length)
  Vector3 axis;        ///< unit
  double radius = 0.0; ///< R (length)
};

/// One or, inside, up to two contacts, the deeper one first; `contacts` is cleared first.
void find_cylinder_contacts(const EllipsoidBody& body, const Cylinder& cylinder,
                            std::vector<WallContact>& contacts);

/// Every sphere of the chain that reaches into the wall; `contacts` is cleared first.
void find_cylinder_contacts(const MultispherePose& pose, const Cylinder& cylinder,
                            std::vector<WallContact>& contacts);

} // namespace ellipsoid
