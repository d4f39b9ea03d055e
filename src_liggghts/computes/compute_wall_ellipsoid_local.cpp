// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "compute_wall_ellipsoid_local.h"

#include "error.h"

using namespace LAMMPS_NS;

void ComputeWallEllipsoidLocal::init() {
  const std::vector<EllipsoidContactCaller*> walls = EllipsoidContactCaller::walls_of(*modify);
  if (walls.empty())
    error->compute_error(FLERR, this,
                         "lists contacts of fix wall/gran/ellipsoid; define such a "
                         "wall before the run");
  set_callers(walls);
}
