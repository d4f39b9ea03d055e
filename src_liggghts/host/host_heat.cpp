// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "host_heat.h"

#include "error.h"
#include "lammps.h"

void ellipsoid_host::refuse_unknown_area(LAMMPS_NS::LAMMPS* lmp, const HeatConduction& heat) {
  if (!heat.is_known)
    lmp->error->all(FLERR, "heat conduction: 'contact_area superquadric' and 'convex', and "
                           "'area_correction yes' with a youngsModulusOriginal that depends on the "
                           "temperature, do not know ellipsoids; use 'contact_area overlap' or "
                           "'constant A', and a constant youngsModulusOriginal");
}
