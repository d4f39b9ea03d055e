// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_check_particles_ellipsoid.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "output.h"
#include "particle_check.h"
#include "update.h"

#include <string>
#include <vector>

using namespace LAMMPS_NS;

namespace {

constexpr int steps_between_checks = 16; // a number that is not finite does not go away by itself

constexpr char caller[] = "atom_style granular/ellipsoid"; // the fix is made by it

bool is_freeze(const Fix& fix) { return std::string(fix.style) == "freeze"; }

} // namespace

void FixCheckParticlesEllipsoid::make_sure(LAMMPS* lmp) {
  static char id[] = "check_particles_ellipsoid", all[] = "all",
              style[] = "check/particles/ellipsoid";
  char* arguments[] = {id, all, style};
  if (lmp->modify->find_fix(id) < 0)
    lmp->modify->add_fix(3, arguments);
}

FixCheckParticlesEllipsoid::FixCheckParticlesEllipsoid(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg) {
  if (narg > 3)
    error->fix_error(FLERR, this, "takes no arguments after its style; remove them");
  nevery = 1;
}

int FixCheckParticlesEllipsoid::setmask() {
  return FixConst::PRE_EXCHANGE | FixConst::PRE_NEIGHBOR | FixConst::END_OF_STEP;
}

void FixCheckParticlesEllipsoid::init() { ellipsoid_host::check_particles(lmp, caller); }

void FixCheckParticlesEllipsoid::setup(int) {
  ellipsoid_host::check_particles(lmp, caller); // also those that were inserted at set-up
  warned_of_none_ = warned_of_two_ = false;
  counted_ = atom->natoms;
  if (update->nsteps > 0)
    check_integrators();
}

/// Before the host seeks the sub-domain of a particle whose position is not finite.
void FixCheckParticlesEllipsoid::pre_exchange() { ellipsoid_host::check_finite(lmp, caller); }

/// New particles may belong to other groups than those before.
void FixCheckParticlesEllipsoid::pre_neighbor() {
  ellipsoid_host::check_particles(lmp, caller);
  if (atom->natoms > counted_)
    check_integrators();
  counted_ = atom->natoms;
}

void FixCheckParticlesEllipsoid::end_of_step() {
  const bigint step = update->ntimestep;
  if (step % steps_between_checks == 0 || step == output->next || step == update->laststep)
    ellipsoid_host::check_finite(lmp, caller);
}

/// Warns of particles that no fix moves or freezes, and of those that two fixes move; once in a
/// run.
void FixCheckParticlesEllipsoid::check_integrators() {
  std::string names;
  std::vector<int> groups;
  int frozen = 0;
  for (int k = 0; k < modify->nfix; ++k) {
    const Fix& fix = *modify->fix[k];
    if (is_freeze(fix))
      frozen |= fix.groupbit;
    if (!fix.time_integrate)
      continue;
    names += (names.empty() ? "" : ", ") + std::string(fix.style) + " (id " + fix.id + ")";
    groups.push_back(fix.groupbit);
  }
  int mine[2] = {0, 0}, all[2]; // particles moved by no fix, by two or more
  for (int i = 0; i < atom->nlocal; ++i) {
    int count = 0;
    for (const int group : groups)
      count += (atom->mask[i] & group) ? 1 : 0;
    mine[0] += count == 0 && !(atom->mask[i] & frozen);
    mine[1] += count > 1;
  }
  MPI_Allreduce(mine, all, 2, MPI_INT, MPI_SUM, world);
  const bool nothing_moves = groups.empty() && atom->natoms == 0;
  const auto warn = [this](bool holds, bool& has_warned, const std::string& text) {
    if (holds && !has_warned && comm->me == 0)
      error->warning(FLERR, text.c_str());
    has_warned = has_warned || holds;
  };
  const std::string whom = nothing_moves ? "new" : std::to_string(all[0]);
  warn(all[0] > 0 || nothing_moves, warned_of_none_,
       whom +
           " ellipsoids are moved by no fix; add 'fix ID GROUP nve/ellipsoid', or 'freeze' them");
  warn(all[1] > 0, warned_of_two_,
       std::to_string(all[1]) + " ellipsoids are moved by two fixes of " + names +
           ", twice as far in each step; give each its own group");
}
