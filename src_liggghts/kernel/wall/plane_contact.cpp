// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall/plane_contact.h"

#include <cmath>

namespace ellipsoid {

void find_plane_contacts(const EllipsoidBody& body, const PlaneWall& plane,
                         std::vector<WallContact>& contacts) {
  contacts.clear();
  const ContactGeometry found = find_plane_contact(body.shape, plane.point, plane.normal);
  if (found.status != ContactStatus::separated)
    contacts.push_back(wall_contact(found));
}

void find_plane_contacts(const ChainPose& pose, const PlaneWall& plane,
                         std::vector<WallContact>& contacts) {
  contacts.clear();
  const SphereChain& chain = *pose.chain;
  const double distance = dot(plane.point, plane.normal);
  const double slope = pose.scale * dot(pose.axis, plane.normal);
  if (distance > (1.0 + search_rounding) *
                     (std::fabs(slope) * chain.half_length() + pose.scale * chain.largest_radius()))
    return;
  for (int k = 0; k < chain.count(); ++k) {
    const double radius = pose.scale * chain.radius(k);
    const double overlap = radius + slope * chain.centre(k) - distance;
    if (!(overlap > 0.0))
      continue;
    const Vector3 centre = (pose.scale * chain.centre(k)) * pose.axis;
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
