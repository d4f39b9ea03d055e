// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

#include <optional>

namespace ellipsoid::post {

struct EnergyOptions {
  std::optional<Vector3> gravity; ///< none: not known, no potential
  std::optional<Vector3> inertia; ///< principal moments of all particles; none: solid ellipsoids
};

/// Sums over all particles, in the units of the file.
struct Energy {
  double translation = 0.0;
  std::optional<double> rotation;  ///< none: the file has no angular velocities
  std::optional<double> potential; ///< none: gravity is not known
};

/// Throws InputError when the file has no masses or velocities, and for bodies of the host whose
/// mass centre or moments cannot be known from their spheres.
Energy energy(const ParticleSet& set, const EnergyOptions& options);

} // namespace ellipsoid::post
