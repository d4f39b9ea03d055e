// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall/cylinder_contact.h"

#include "wall/surface_points.h"
#include "wall/wall_tolerances.h"

#include <cmath>

namespace ellipsoid {

namespace {

enum class Side { inside, outside };

Vector3 way_to_axis(const Cylinder& c) { return c.centre - dot(c.centre, c.axis) * c.axis; }

Side side_of(const Cylinder& c, const Vector3& to_axis) {
  return norm(to_axis) < c.radius ? Side::inside : Side::outside;
}

/// What the wall's curvature makes of the reduced radius at a plane.
/// @param[in] w the body's radius of curvature around the axis (length)
double reduced_radius(double at_plane, double w, double wall_radius, Side side) {
  const double factor = side == Side::inside
                            ? std::fmax(wall_tolerance::conformity, 1.0 - w / wall_radius)
                            : 1.0 + w / wall_radius;
  return at_plane / std::sqrt(factor);
}

WallContact contact_along(const EllipsoidShape& body, const Cylinder& cylinder,
                          const Vector3& to_axis, Side side, const Vector3& normal) {
  const double wall = side == Side::inside ? cylinder.radius : -cylinder.radius;
  const Vector3 wall_point = to_axis + wall * normal;
  WallContact c = wall_contact(find_plane_contact(body, wall_point, normal));
  const Vector3 tangent = cross(cylinder.axis, normal), a_t = body.a_matrix * tangent;
  const double s = support(body, normal), a_nt = dot(normal, a_t) / s;
  const double w = (dot(tangent, a_t) - a_nt * a_nt) / s;
  c.reduced_radius = reduced_radius(c.reduced_radius, w, cylinder.radius, side);
  return c;
}

} // namespace

void find_cylinder_contacts(const EllipsoidBody& body, const Cylinder& cylinder,
                            std::vector<WallContact>& contacts) {
  contacts.clear();
  const Vector3 to_axis = way_to_axis(cylinder);
  const Side side = side_of(cylinder, to_axis);
  const Shadow shadow = shadow_along(body.shape, cylinder.axis);
  const auto add = [&](const Vector3& normal) {
    const WallContact c = contact_along(body.shape, cylinder, to_axis, side, normal);
    if (c.overlap >= 0.0)
      contacts.push_back(c);
  };
  if (side == Side::outside) {
    add(nearest_normal(shadow, to_axis));
    return;
  }
  const FarthestNormals farthest = farthest_normals(shadow, to_axis);
  for (int k = 0; k < farthest.count; ++k)
    add(farthest.normal[static_cast<std::size_t>(k)]);
}

void find_cylinder_contacts(const MultispherePose& pose, const Cylinder& cylinder,
                            std::vector<WallContact>& contacts) {
  contacts.clear();
  const Vector3 to_axis = way_to_axis(cylinder);
  const Side side = side_of(cylinder, to_axis);
  const SphereCentres spheres(pose);
  for (int k = 0; k < pose.body->count(); ++k) {
    const Vector3 centre = spheres.at(k);
    const double radius = spheres.radius(k);
    const Vector3 from_axis = centre - part_along(centre, cylinder.axis) - to_axis;
    const double distance = norm(from_axis);
    const double overlap = side == Side::inside ? radius + distance - cylinder.radius
                                                : radius + cylinder.radius - distance;
    if (!(overlap > 0.0 && distance > 0.0))
      continue;
    WallContact c;
    c.normal = ((side == Side::inside ? 1.0 : -1.0) / distance) * from_axis;
    c.foot = centre + (radius - overlap) * c.normal;
    c.point = centre + (radius - 0.5 * overlap) * c.normal;
    c.overlap = overlap;
    c.reduced_radius = reduced_radius(radius, radius, cylinder.radius, side);
    c.sphere = k;
    contacts.push_back(c);
  }
}

} // namespace ellipsoid
