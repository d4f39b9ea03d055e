// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How far a point of a region of the host is from leaving it.
#pragma once

#include "math/vector3.h"

namespace LAMMPS_NS {
class Domain;
class Region;
} // namespace LAMMPS_NS

namespace ellipsoid_host {

/// Distance (length) that is never too large and may end at `enough`; negative: the point is
/// outside. Unions and intersections ask their members, as the host's own distance leaves out
/// edges between these.
double room_in_region(LAMMPS_NS::Domain& domain, LAMMPS_NS::Region& region,
                      const ellipsoid::Vector3& point, double enough);

} // namespace ellipsoid_host
