// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "compute_wall_ellipsoid_local.h"

#include "error.h"
#include "fix.h"
#include "modify.h"

using namespace LAMMPS_NS;

void ComputeWallEllipsoidLocal::init() {
  std::vector<EllipsoidContactCaller*> walls;
  for (int k = 0; k < modify->nfix; ++k)
    if (auto* wall = dynamic_cast<EllipsoidContactCaller*>(modify->fix[k]))
      walls.push_back(wall);
  if (walls.empty())
    error->compute_error(FLERR, this, "lists contacts of fix wall/gran/ellipsoid; define such a "
                                      "wall before the run");
  take_callers(walls);
}
