// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "restart_step.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "force.h"
#include "integrate.h"
#include "lammps.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "update.h"

using LAMMPS_NS::LAMMPS;

namespace {

/// As command write_restart: particles may have moved since the neighbour lists were built, out of
/// a periodic box or to another rank.
void exchange_particles(LAMMPS* lmp) {
  lmp->modify->setup_pre_exchange();
  if (lmp->domain->triclinic)
    lmp->domain->x2lamda(lmp->atom->nlocal);
  lmp->domain->pbc();
  lmp->domain->reset_box();
  lmp->comm->setup();
  lmp->comm->exchange();
  lmp->comm->borders();
  if (lmp->domain->triclinic)
    lmp->domain->lamda2x(lmp->atom->nlocal + lmp->atom->nghost);
}

/// As command run does: sorted particles, new neighbour lists, forces with the velocities of the
/// full step.
void set_up(LAMMPS* lmp) {
  const auto builds = lmp->neighbor->ncalls;
  lmp->update->integrate->setup_minimal(1);
  lmp->neighbor->ncalls = builds;
}

bool has_ellipsoids(LAMMPS* lmp) { return lmp->force->pair_match("gran/ellipsoid", 1); }

} // namespace

void ellipsoid_host::begin_from_present_box(LAMMPS* lmp) {
  if (!has_ellipsoids(lmp))
    return;
  lmp->domain->set_initial_box();
  lmp->domain->reset_box();
}

void ellipsoid_host::go_on_as_from_restart_file(LAMMPS* lmp) {
  const auto step = lmp->update->ntimestep;
  if (!has_ellipsoids(lmp) || !lmp->output->is_restart_step(step))
    return;
  exchange_particles(lmp);
  lmp->output->write_restart_files(step);
  begin_from_present_box(lmp);
  set_up(lmp);
}
