// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Particles that leave the simulation box are lost when particles go to other ranks.
#pragma once

#include "lmptype.h"

namespace ellipsoid_host {

/// To be told of each exchange of particles between ranks: numbers over all ranks.
void note_exchange(LAMMPS_NS::bigint before, LAMMPS_NS::bigint after);

/// Particles lost since the last call, over all ranks.
LAMMPS_NS::bigint collect_losses();

} // namespace ellipsoid_host
