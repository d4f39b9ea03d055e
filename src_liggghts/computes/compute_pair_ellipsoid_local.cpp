// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "compute_pair_ellipsoid_local.h"

#include "error.h"

using namespace LAMMPS_NS;

void ComputePairEllipsoidLocal::init() {
  EllipsoidContactCaller* pair = EllipsoidContactCaller::pair_of(*force);
  if (!pair)
    error->compute_error(FLERR, this,
                         "lists contacts of pair_style gran/ellipsoid; use that style");
  set_callers({pair});
}
