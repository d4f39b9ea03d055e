// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

#include <optional>

namespace ellipsoid::post {

struct EnergyOptions {
  Vector3 gravity{0.0, -9.81, 0.0};
  std::optional<Vector3> inertia; ///< principal moments of all particles; none: solid ellipsoids
};

/// Sums over all particles, in the units of the file.
struct Energy {
  double translation = 0.0, rotation = 0.0, potential = 0.0;
};

/// Throws InputError when the file has no masses or velocities.
Energy energy(const ParticleSet& set, const EnergyOptions& options);

} // namespace ellipsoid::post
