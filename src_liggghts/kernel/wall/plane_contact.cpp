// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall/plane_contact.h"

namespace ellipsoid {

void find_plane_contacts(const EllipsoidBody& body, const PlaneWall& plane,
                         std::vector<WallContact>& contacts) {
  contacts.clear();
  const ContactGeometry found = find_plane_contact(body.shape, plane.point, plane.normal);
  if (found.status != ContactStatus::separated)
    contacts.push_back(wall_contact(found));
}

void find_plane_contacts(const MultispherePose& pose, const PlaneWall& plane,
                         std::vector<WallContact>& contacts) {
  contacts.clear();
  const double distance = dot(plane.point, plane.normal);
  if (distance > (1.0 + search_rounding) * largest_reach(pose, plane.normal))
    return;
  const SphereCentres spheres(pose);
  for (int k = 0; k < pose.body->count(); ++k) {
    const double radius = spheres.radius(k);
    const Vector3 centre = spheres.at(k);
    const double overlap = radius + dot(centre, plane.normal) - distance;
    if (!(overlap > 0.0))
      continue;
    WallContact c;
    c.normal = plane.normal;
    c.foot = centre + (radius - overlap) * plane.normal;
    c.point = centre + (radius - 0.5 * overlap) * plane.normal;
    c.overlap = overlap;
    c.reduced_radius = radius;
    c.sphere = k;
    contacts.push_back(c);
  }
}

} // namespace ellipsoid
