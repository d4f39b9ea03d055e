// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

/// Stops with one line when a particle of this rank cannot be simulated: semi-axes, mass and
/// moments must be finite and > 0 and the moments those of a body, the blockiness 2, the bounding
/// sphere that of the semi-axes, position and velocities finite, the quaternion of length 1. The
/// host's templates, `create_atoms`, `set` and readers of files do not check this.
/// @param[in] caller begins the message
void check_particles(LAMMPS_NS::LAMMPS* lmp, const char* caller);

/// Stops with one line when a position, velocity, orientation or angular momentum of a particle of
/// this rank is not finite.
void check_finite(LAMMPS_NS::LAMMPS* lmp, const char* caller);

} // namespace ellipsoid_host
