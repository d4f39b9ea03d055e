// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

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
  const double* const* overlap_ratio; ///< overlap at the true stiffness over the simulated; null: 1
  double* flux;                       ///< power
  double** directional_flux;          ///< power length
  double* area;                       ///< sum over contacts (length^2); null: not wanted
  double* contact_count;              ///< null: not wanted
  bool by_radius = false;             ///< conductance by sqrt(area / pi), not sqrt(area)
  bool is_known = true;               ///< whether the area is one of those above
};

/// Stops where the area of a contact is one that ellipsoids do not have.
void refuse_unknown_area(LAMMPS_NS::LAMMPS* lmp, const HeatConduction& heat);

} // namespace ellipsoid_host
