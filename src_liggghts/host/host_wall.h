// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Base class of a granular wall, the same for every host.
#pragma once

#include "atom.h"
#include "fix_wall_gran.h"
#include "host_heat.h"
#include "host_variants.h"

namespace ellipsoid_host {

class HostWall : public LAMMPS_NS::FixWallGran {
 protected:
  HostWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : FixWallGran(lmp, narg, arg) {}

  /// When a run is set up: stops where the area of a contact is one that ellipsoids do not have.
  void check_heat() {
#ifdef ELLIPSOID_HOST_INL
    if (heattransfer_flag_)
      refuse_unknown_area(lmp, heat());
#endif
  }
  /// Before the contacts of a step.
  void begin_heat() {
#ifdef ELLIPSOID_HOST_INL
    if (heattransfer_flag_)
      heatPhy.beginPass();
#endif
  }
  /// Radius of the sphere whose overlap with a plane the host takes for the area of a contact; 0:
  /// it takes another area.
  /// @param[in] of_contact radius that the contact's models were given
  double sphere_of_heat(int particle, double of_contact) const {
#ifdef ELLIPSOID_HOST_INL
    static_cast<void>(of_contact);
    return heat().fixed_area > 0.0 ? 0.0 : atom->radius[particle];
#else
    static_cast<void>(particle);
    constexpr int by_overlap = 0; // CONDUCTION_CONTACT_AREA_OVERLAP of the host's fix_wall_gran.cpp
    return area_calculation_mode_ == by_overlap ? of_contact : 0.0;
#endif
  }

 private:
#ifdef ELLIPSOID_HOST_INL
  HeatConduction heat() const {
    HeatConduction settings{};
    heatPhy.tell(settings);
    return settings;
  }
#endif
};

} // namespace ellipsoid_host
