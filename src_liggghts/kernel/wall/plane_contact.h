// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts with a plane as a wall. Conventions: ellipsoid_contact.h.
#pragma once

#include "multisphere/multisphere_contact.h"
#include "wall/wall_contact.h"

#include <vector>

namespace ellipsoid {

struct PlaneWall {
  Vector3 point;  ///< any point of the plane, relative to the particle's centre (length)
  Vector3 normal; ///< unit, from the particle into the wall
};

/// Closed form; `contacts` is cleared first.
void find_plane_contacts(const EllipsoidBody& body, const PlaneWall& plane,
                         std::vector<WallContact>& contacts);

/// Every sphere of the chain that reaches into the wall; `contacts` is cleared first.
void find_plane_contacts(const MultispherePose& pose, const PlaneWall& plane,
                         std::vector<WallContact>& contacts);

} // namespace ellipsoid
