// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "surface_paths.h"

#include "atom.h"
#include "particle_arrays.h"

#include <cmath>

using namespace LIGGGHTS;

namespace {

/// Upper bound of the angle between two orientations (rad), from the distance of their unit
/// quaternions, 2 sin(angle / 4): 4 asin(d / 2) <= 2.05 d up to d = 0.5, <= pi d always.
double largest_angle(double quaternion_distance) {
  return (quaternion_distance < 0.5 ? 2.05 : M_PI) * quaternion_distance;
}

} // namespace

bool SurfacePaths::update(const LAMMPS_NS::Atom& atom, bool new_lists) {
  const std::size_t count = static_cast<std::size_t>(atom.nlocal + atom.nghost);
  const bool restart = new_lists || count != travels_.size();
  if (restart) {
    poses_.resize(count);
    travels_.restart(count);
  }
  const ParticleArrays particles(atom);
  for (std::size_t i = 0; i < count; ++i) {
    Pose& pose = poses_[i];
    const double *x = particles.x[static_cast<int>(i)], *q = particles.quaternion[static_cast<int>(i)];
    double way = 0.0, turn = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double change = x[k] - pose.x[k];
      way += change * change;
      pose.x[k] = x[k];
    }
    for (int k = 0; k < 4; ++k) {
      const double change = q[k] - pose.quaternion[k];
      turn += change * change;
      pose.quaternion[k] = q[k];
    }
    if (restart)
      continue;
    travels_.add(i, std::sqrt(way) + particles.radius[i] * largest_angle(std::sqrt(turn)));
  }
  return restart;
}
