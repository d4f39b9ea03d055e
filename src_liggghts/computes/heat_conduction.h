// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#ifndef HEAT_CONDUCTION_H_
#define HEAT_CONDUCTION_H_

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

/// What the host's fix heat/gran/conduction knows; arrays per particle, tables per type from 0.
struct HeatConduction {
  int groupbit;
  const double* temperature;
  const double* conductivity;         ///< power / (length temperature)
  double fixed_area;                  ///< of every contact (length^2); 0: that of the overlap
  const double* const* overlap_ratio; ///< of the overlaps of the true stiffness; null: 1
  double* flux;                       ///< power
  double** directional_flux;
  double* area;          ///< sum over contacts (length^2); null: not wanted
  double* contact_count; ///< null: not wanted
};

/// Called by the patched fix when a run is set up: contacts are noted down from now on.
void keep_contacts_for_heat(LAMMPS_NS::LAMMPS* lmp);

/// Called by the patched fix instead of its own loop over bounding spheres.
/// @return false, and nothing is done, where particles are no ellipsoids
bool conduct_heat(LAMMPS_NS::LAMMPS* lmp, const HeatConduction& heat);

} // namespace ellipsoid_host

#endif
