// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "room_in_region.h"

#include "domain.h"
#include "region.h"
#include "region_intersect.h"
#include "region_union.h"

#include <algorithm>

using namespace LAMMPS_NS;
using ellipsoid::Vector3;

namespace ellipsoid_host {
namespace {

double room_in(Domain& domain, Region& region, const Vector3& point, double enough, bool outside);

/// @param[in] largest of the members, or else the smallest
template <class Compound>
double room_in_members(Domain& domain, Compound& region, const Vector3& point, double enough,
                       bool outside, bool largest) {
  double found = largest ? -1.0 : enough;
  for (int k = 0; k < region.members(); ++k) {
    const int member = domain.find_region(const_cast<char*>(region.member(k)));
    const double room = room_in(domain, *domain.regions[member], point, enough, outside);
    found = largest ? std::max(found, room) : std::min(found, room);
  }
  return found;
}

/// Of a region that is no union or intersection.
double room_in_shape(Region& region, const Vector3& point, double enough, bool outside) {
  const int interior = region.interior;
  if (outside)
    region.interior = !interior;
  double found = -1.0;
  if (region.match(point.x, point.y, point.z)) {
    found = enough;
    const int contacts = region.surface(point.x, point.y, point.z, enough);
    for (int k = 0; k < contacts; ++k)
      found = std::min(found, region.contact[k].r);
  }
  region.interior = interior;
  return found;
}

/// @param[in] outside the room is that of all that the region does not hold: of a union the
/// intersection of what its members do not hold, and the other way round
double room_in(Domain& domain, Region& region, const Vector3& point, double enough, bool outside) {
  const bool is_outside = outside != (region.interior == 0);
  if (auto* all = dynamic_cast<RegUnion*>(&region))
    return room_in_members(domain, *all, point, enough, is_outside, !is_outside);
  if (auto* common = dynamic_cast<RegIntersect*>(&region))
    return room_in_members(domain, *common, point, enough, is_outside, is_outside);
  return room_in_shape(region, point, enough, outside);
}

} // namespace

double room_in_region(Domain& domain, Region& region, const Vector3& point, double enough) {
  return room_in(domain, region, point, enough, false);
}

} // namespace ellipsoid_host
