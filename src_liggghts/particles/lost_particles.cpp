// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "lost_particles.h"

using LAMMPS_NS::bigint;

namespace {
bigint lost = 0;
}

void ellipsoid_host::note_exchange(bigint before, bigint after) { lost += before - after; }

bigint ellipsoid_host::take_losses() {
  const bigint taken = lost;
  lost = 0;
  return taken;
}
