// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "surface_motions.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "particle_arrays.h"

#include <algorithm>
#include <cmath>

using namespace LIGGGHTS;

namespace {

/// Upper bound of the angle between two orientations (rad), from the distance of their unit
/// quaternions, 2 sin(angle / 4): 4 asin(d / 2) <= 2.05 d up to d = 0.5, <= pi d always.
double largest_angle(double quaternion_distance) {
  return (quaternion_distance < 0.5 ? 2.05 : M_PI) * quaternion_distance;
}

/// Largest |dh/d angle| of the support function h = sqrt(a^2 cos^2 + c^2 sin^2): a - c (length).
double turning_radius(const double* semi_axes) {
  const auto [smallest, largest] = std::minmax({semi_axes[0], semi_axes[1], semi_axes[2]});
  return largest - smallest;
}

} // namespace

void SurfaceMotions::restart(const LAMMPS_NS::Atom& atom, double time_step, std::size_t count) {
  poses_.resize(count);
  clocks_.restart(count);
  const ParticleArrays particles(atom);
  for (std::size_t k = 0; k < count; ++k) {
    const int i = static_cast<int>(k);
    std::copy_n(particles.x[i], 3, poses_[k].x);
    std::copy_n(particles.quaternion[i], 4, poses_[k].quaternion);
    clocks_.expect(k, {time_step * ellipsoid_host::vector(particles.v[i]),
                       time_step * turning_radius(particles.shape[i]) *
                           norm(ellipsoid_host::vector(particles.omega[i]))});
  }
}

bool SurfaceMotions::update(const LAMMPS_NS::Atom& atom, double time_step, bool new_lists) {
  const std::size_t count = static_cast<std::size_t>(atom.nlocal + atom.nghost);
  if (new_lists || count != clocks_.size()) {
    restart(atom, time_step, count);
    return true;
  }
  const ParticleArrays particles(atom);
  clocks_.begin_step();
  for (std::size_t k = 0; k < count; ++k) {
    const int i = static_cast<int>(k);
    Pose& pose = poses_[k];
    const double *x = particles.x[i], *q = particles.quaternion[i];
    double way[3], turn = 0.0;
    for (int l = 0; l < 3; ++l) {
      way[l] = x[l] - pose.x[l];
      pose.x[l] = x[l];
    }
    for (int l = 0; l < 4; ++l) {
      const double change = q[l] - pose.quaternion[l];
      turn += change * change;
      pose.quaternion[l] = q[l];
    }
    clocks_.advance(k, {{way[0], way[1], way[2]},
                        turning_radius(particles.shape[i]) * largest_angle(std::sqrt(turn))});
  }
  return false;
}
