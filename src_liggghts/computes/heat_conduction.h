// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "host_heat.h"

namespace ellipsoid_host {

/// Called by the patched fix when a run is set up: contacts are noted down from now on.
void keep_contacts_for_heat(LAMMPS_NS::LAMMPS* lmp);

/// Called by the patched fix instead of its own loop over bounding spheres.
/// @return false, and nothing is done, where particles are no ellipsoids
bool conduct_heat(LAMMPS_NS::LAMMPS* lmp, const HeatConduction& heat);

} // namespace ellipsoid_host
