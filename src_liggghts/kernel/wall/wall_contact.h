// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// One contact of a particle with a wall of any kind. Every finder of contacts (plane_contact.h,
// cylinder_contact.h, mesh_contact.h) gives these, for smooth ellipsoids and for chains of spheres.
#pragma once

#include "ellipsoid/ellipsoid_contact.h"

namespace ellipsoid {

/// An ellipsoid with all that contacts with walls need.
struct EllipsoidBody {
  EllipsoidShape shape;
  Vector3 semiaxes; ///< (length)
  Rotation3 axes;   ///< columns: the body's axes in space
  EllipsoidBody(const Vector3& semiaxes_, const Quaternion& orientation)
      : shape(make_shape(semiaxes_, orientation)), semiaxes(semiaxes_),
        axes(rotation(orientation)) {}
};

/// Lengths are relative to the particle's centre.
struct WallContact {
  Vector3 normal;              ///< unit, from the particle into the wall
  Vector3 foot;                ///< the contact's point on the wall (length)
  Vector3 point;               ///< middle of the overlap (length)
  double overlap = 0.0;        ///< (length)
  double reduced_radius = 0.0; ///< R of (19) (length)
  int sphere = -1;             ///< number in the chain; -1: a smooth ellipsoid
  int triangle = -1;           ///< index in the list of triangles; -1: no triangle
};

/// With the tangent plane of a wall.
inline WallContact wall_contact(const ContactGeometry& plane) {
  WallContact c;
  c.normal = plane.normal;
  c.foot = plane.point - (0.5 * plane.overlap) * plane.normal;
  c.point = plane.point;
  c.overlap = plane.overlap;
  c.reduced_radius = plane.reduced_radius;
  return c;
}

} // namespace ellipsoid
