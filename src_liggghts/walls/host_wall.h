// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Base class of a granular wall, the same for every host.
#pragma once

#include "atom.h"
#include "fix_wall_gran.h"
#include "host_contact.h"
#include "host_heat.h"
#include "host_variants.h"

#ifdef ELLIPSOID_HOST_PFM
#include "pfm_wall.h"
#else

namespace ellipsoid_host {

class HostWall : public LAMMPS_NS::FixWallGran {
 protected:
  HostWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : FixWallGran(lmp, narg, arg) {}

  /// The contact models, which have contact_match(kind, name).
  auto& models() { return *impl; }
  LAMMPS_NS::PrimitiveWall& primitive_wall() { return *primitiveWall_; }
  /// The values that the wall keeps of each particle's contacts; the host deletes the fix with the
  /// wall.
  void set_history(LAMMPS_NS::FixPropertyAtom* fix) { fix_history_primitive_ = fix; }
  double* history_values(int particle) { return fix_history_primitive_->array_atom[particle]; }
  /// Forces or stresses of single contacts, or sums of normal forces.
  bool stores_of_contacts() {
    return store_force_contact_ || store_force_contact_stress_ || store_sum_normal_force();
  }

  /// Calls the contact models.
  /// @param[in] mesh its number, and the triangle's, are of use only with it; null: a primitive
  /// wall
  void apply_models(LCM::SurfacesIntersectData& data, double* wall_velocity,
                    LAMMPS_NS::FixMeshSurface* mesh, int mesh_number, int triangle) {
    if (mesh) {
      data.mesh = mesh->triMesh();
      data.fix_mesh = mesh;
      fix_wallforce_contact_ = mesh->meshforceContact();
      fix_wallforce_contact_stress_ = mesh->meshforceContactStress();
    }
    impl->compute_force(this, data, true, wall_velocity, nullptr, mesh ? mesh_number : 0,
                        mesh ? mesh->triMesh() : nullptr, mesh ? triangle : 0);
  }

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
  /// The overlap that the host takes for the area of a contact: at the true stiffness.
  double depth_of_heat(int particle, double overlap) const {
#ifdef ELLIPSOID_HOST_INL
    const double* const* const ratio = heat().overlap_ratio;
#else
    const double* const* const ratio = deltan_ratio;
#endif
    return ratio ? overlap * ratio[atom->type[particle] - 1][atom_type_wall_ - 1] : overlap;
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

#endif
