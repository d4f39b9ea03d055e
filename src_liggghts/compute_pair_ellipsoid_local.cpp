// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "compute_pair_ellipsoid_local.h"

#include "error.h"
#include "force.h"
#include "pair.h"

using namespace LAMMPS_NS;

void ComputePairEllipsoidLocal::init() {
  auto* pair = dynamic_cast<EllipsoidContactCaller*>(force->pair);
  if (!pair)
    error->compute_error(FLERR, this, "lists contacts of pair_style gran/ellipsoid; use that style");
  take_callers({pair});
}
