// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "surface_motions.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "multisphere/motion_batch.h"
#include "particle_arrays.h"

using namespace ellipsoid_host;

void SurfaceMotions::restart(const LAMMPS_NS::Atom& atom, double time_step, std::size_t count) {
  const ParticleArrays particles(atom);
  centres_.assign(particles.x[0], particles.x[0] + 3 * count);
  orientations_.assign(particles.quaternion[0], particles.quaternion[0] + 4 * count);
  turning_radii_.resize(count);
  clocks_.restart(count);
  for (std::size_t k = 0; k < count; ++k) {
    const int i = static_cast<int>(k);
    const double* axes = particles.shape[i];
    turning_radii_[k] = ellipsoid::turning_radius(axes[0], axes[1], axes[2]);
    clocks_.expect(k, {time_step * vector(particles.v[i]),
                       time_step * turning_radii_[k] * norm(vector(particles.omega[i]))});
  }
}

bool SurfaceMotions::update(const LAMMPS_NS::Atom& atom, double time_step, bool new_lists) {
  const std::size_t count = static_cast<std::size_t>(atom.nlocal + atom.nghost);
  if (new_lists || count != clocks_.size()) {
    restart(atom, time_step, count);
    return true;
  }
  const ParticleArrays particles(atom);
  clocks_.advance_all([&](std::size_t first, ellipsoid::Motions& motions) {
    const int i = static_cast<int>(first);
    ellipsoid::measure_motions({&turning_radii_[first], particles.x[i], particles.quaternion[i],
                                &centres_[3 * first], &orientations_[4 * first]},
                               motions);
  });
  return false;
}
