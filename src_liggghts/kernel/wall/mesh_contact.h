// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts of a particle with a wall of many triangles: which of the triangles' contacts count.
//
// Each triangle near the particle offers its contacts (triangle_contact.h). Of these,
//  - a contact at an edge or corner counts only if no triangle that shares the point reaches in
//    front of the contact's tangent plane: else the neighbour's own contact is the true one. So
//    there is none at the seam of coplanar triangles nor in a groove, and one on a ridge;
//  - a contact point that the body's centre does not see, because a triangle lies between, is none;
//  - a deep contact gives way to one with a smaller overlap whose tangent plane it lies in or
//    beyond: the other side of a ridge, the rim of the same plate;
//  - the same contact offered by several triangles counts once;
//  - a contact that lies in or beyond the tangent plane of a deeper one is part of that: the rim
//    of a coplanar plate beyond a crack, a sheet close behind. Small steps (`unmatched`), which
//    corners of triangles make that do not match, do not matter near a contact;
//  - contacts on triangles of the same surface (nearly coplanar: the caller says which) are one
//    where the patch of one reaches the foot of the other. Farther apart they are two supports.
// Of contacts that are one, the deepest counts: it changes steadily while the body moves.
// If nothing is left although the body reaches into the wall (deep overlap of a slender body), the
// contact is that of find_growing_contact() at the triangle that is reached first. Every touching
// body has at least one contact.
#pragma once

#include "wall/triangle_contact.h"

#include <functional>
#include <vector>

namespace ellipsoid {

/// Whether two triangles, by their indices, belong to one smooth surface and share a corner.
using SameSurface = std::function<bool(int, int)>;

/// Contacts of an ellipsoid, ordered by the index of the triangle; `contacts` is cleared first.
/// @param[in] triangles all triangles within the particle's reach; none twice
void find_mesh_contacts(const EllipsoidBody& body, const std::vector<Triangle>& triangles,
                        const SameSurface& same_surface, std::vector<TriangleContact>& contacts);

/// Contacts of the spheres of a chain, in the order of the spheres.
void find_mesh_contacts(const MultispherePose& pose, const std::vector<Triangle>& triangles,
                        const SameSurface& same_surface, std::vector<TriangleContact>& contacts);

/// Whether a corner of one triangle lies on the other (within `margin`, length).
bool adjoin(const Triangle& first, const Triangle& second, double margin);

} // namespace ellipsoid
