// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "near_candidates.h"

#include "atom.h"
#include "domain.h"
#include "ellipsoid_host.h"
#include "force.h"
#include "multisphere/motion_batch.h"
#include "neighbor.h"
#include "pair_gran_ellipsoid.h"
#include "particle_arrays.h"
#include "surface_contacts.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace ellipsoid_host {

namespace {

/// Share of long or flat particles above which choosing pairs by true shape pays.
constexpr double share_of_long = 0.1;
/// The margin is half the skin, as for centres in the host's lists, but at least what the fastest
/// surface moves in so many steps: else lists would be made anew too often when bodies spin fast.
constexpr double steps_in_margin = 20.0;

/// What the surface of a particle moves at most in a step (length).
double way(const ParticleArrays& particles, int i, double time_step) {
  const double* axes = particles.shape[i];
  return time_step *
         (norm(vector(particles.v[i])) +
          ellipsoid::turning_radius(axes[0], axes[1], axes[2]) * norm(vector(particles.omega[i])));
}

} // namespace

void NearCandidates::prepare(LAMMPS& lmp) {
  by_shape_ = false;
  // images move with the sides of the box; models may act at a distance
  if (lmp.domain->box_change || lmp.neighbor->includegroup ||
      lmp.neighbor->contactDistanceFactor != 1.0)
    return;
  const ParticleArrays particles(*lmp.atom);
  double mine[2] = {0.0, static_cast<double>(lmp.atom->nlocal)}, fastest = 0.0;
  for (int i = 0; i < lmp.atom->nlocal; ++i) {
    mine[0] += ellipsoid::LongBodies::is_long_or_flat(particles.shape[i]) ? 1.0 : 0.0;
    fastest = std::max(fastest, way(particles, i, lmp.update->dt));
  }
  double all[2] = {0.0, 0.0}, fastest_of_all = 0.0;
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, lmp.world);
  MPI_Allreduce(&fastest, &fastest_of_all, 1, MPI_DOUBLE, MPI_MAX, lmp.world);
  by_shape_ = all[0] > share_of_long * all[1];
  margin_ = std::max(0.5 * lmp.neighbor->skin, steps_in_margin * fastest_of_all);
}

bool NearCandidates::begin(const LAMMPS& lmp, SurfaceContacts& contacts) {
  const Atom& atom = *lmp.atom;
  const auto count = static_cast<std::size_t>(atom.nlocal + atom.nghost);
  if (by_shape_) {
    const ParticleArrays particles(atom);
    bounds_.resize(count);
    for (std::size_t k = 0; k < count; ++k)
      bounds_[k] = contacts.bounds(static_cast<int>(k));
    bodies_.build({particles.x[0], particles.quaternion[0], bounds_.data(), count}, margin_);
    const auto owned = static_cast<std::size_t>(atom.nlocal);
    centres_.assign(particles.x[0], particles.x[0] + 3 * owned);
    orientations_.assign(particles.quaternion[0], particles.quaternion[0] + 4 * owned);
    return true;
  }
  if (lmp.neighbor->includegroup || !ellipsoid::SizeGrids::are_worthwhile(atom.radius, count))
    return false;
  grids_.build(atom.x[0], atom.radius, count,
               {lmp.neighbor->contactDistanceFactor, lmp.neighbor->skin});
  return true;
}

bool NearCandidates::are_outdated(const LAMMPS& lmp) const {
  if (!by_shape_)
    return false;
  const int mine = moved_too_far(lmp) ? 1 : 0;
  int any = mine;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, lmp.world);
  return any != 0;
}

/// Of the particles that this rank owned when the lists were made; it still does.
bool NearCandidates::moved_too_far(const LAMMPS& lmp) const {
  const ParticleArrays particles(*lmp.atom);
  const std::size_t owned =
      std::min(static_cast<std::size_t>(lmp.atom->nlocal), centres_.size() / 3);
  for (std::size_t k = 0; k < owned; ++k) {
    const int i = static_cast<int>(k);
    const double *q = particles.quaternion[i], *was = &orientations_[4 * k];
    double turned = 0.0; // along the path: quaternions do not change their sign
    for (int c = 0; c < 4; ++c)
      turned += (q[c] - was[c]) * (q[c] - was[c]);
    const double moved = norm(vector(particles.x[i]) - vector(&centres_[3 * k])) +
                         bounds_[k].turning_radius * ellipsoid::largest_angle(std::sqrt(turned));
    if (moved > margin_)
      return true;
  }
  return false;
}

NearCandidates* near_candidates(LAMMPS* lmp, int i) {
  auto* pair = dynamic_cast<PairGranEllipsoid*>(lmp->force->pair);
  return pair ? pair->candidates_of(i) : nullptr;
}

} // namespace ellipsoid_host
