// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "lost_particles.h"

#include <utility>

using LAMMPS_NS::bigint;

namespace {
bigint lost = 0;
}

void ellipsoid_host::note_exchange(bigint before, bigint after) { lost += before - after; }

bigint ellipsoid_host::collect_losses() { return std::exchange(lost, bigint{0}); }
