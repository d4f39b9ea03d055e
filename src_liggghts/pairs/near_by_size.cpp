// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "near_by_size.h"

#include "atom.h"
#include "force.h"
#include "neighbor.h"
#include "pair_gran_ellipsoid.h"

using namespace LAMMPS_NS;

namespace ellipsoid_host {

bool NearBySize::begin(const LAMMPS& lmp) {
  const Atom& atom = *lmp.atom;
  const auto count = static_cast<std::size_t>(atom.nlocal + atom.nghost);
  if (lmp.neighbor->includegroup || !ellipsoid::SizeGrids::are_worthwhile(atom.radius, count))
    return false;
  grids_.build(atom.x[0], atom.radius, count,
               {lmp.neighbor->contactDistanceFactor, lmp.neighbor->skin});
  return true;
}

NearBySize* near_by_size(LAMMPS* lmp, int i) {
  auto* pair = dynamic_cast<PairGranEllipsoid*>(lmp->force->pair);
  return pair ? pair->near_by_size(i) : nullptr;
}

} // namespace ellipsoid_host
