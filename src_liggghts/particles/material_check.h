// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

/// Stops where a run would begin with a material that cannot be, and that the host accepts:
/// negative friction, stiffness, damping, cohesion, conductivity; or with a time step that is not
/// positive.
void check_materials(LAMMPS_NS::LAMMPS* lmp);

} // namespace ellipsoid_host
