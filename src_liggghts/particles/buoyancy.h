// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

/// Called by the patched fix buoyancy: adds force and torque of a liquid at rest on particle i.
/// @param[in] dim   axis of gravity: 0, 1, 2
/// Stops with one line for a clump.
/// @param[in] level of the liquid's surface along it (length)
/// @param[in] down  -1 or 1: where gravity points
/// @param[in] weight of the liquid per volume (force/length^3)
/// @param[in,out] total force on all particles
/// @return false, and nothing is done, where particles are no ellipsoids
bool add_buoyancy(LAMMPS_NS::LAMMPS* lmp, int i, int dim, double level, double down, double weight,
                  double* total);

} // namespace ellipsoid_host
