// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Tangential contact model history/viscous: eq. (24) of Markauskas et al. 2010 on any surface.
#ifdef TANGENTIAL_MODEL
// clang-format off
TANGENTIAL_MODEL(TANGENTIAL_HISTORY_VISCOUS,history/viscous,40)
// clang-format on
#else
#ifndef LMP_TANGENTIAL_MODEL_HISTORY_VISCOUS_H
#define LMP_TANGENTIAL_MODEL_HISTORY_VISCOUS_H

#include "atom.h"
#include "contact_models.h"
#include "ellipsoid_host.h"
#include "global_properties.h"
#include "law/tangential_laws.h"
#include "slip_direction_setting.h"
#include "tangential_model_base.h"
#include "update.h"

#include <string>

namespace LIGGGHTS {
namespace ContactModels {

template <> class TangentialModel<TANGENTIAL_HISTORY_VISCOUS> : public TangentialModelBase {
 public:
  TangentialModel(LAMMPS* lmp, IContactHistorySetup* hsetup, class ContactModelBase* c)
      : TangentialModelBase(lmp, hsetup, c) {
    spring_offset_ = hsetup->add_history_value("springx", "1");
    hsetup->add_history_value("springy", "1");
    hsetup->add_history_value("springz", "1");
  }

  void registerSettings(Settings& settings) {
    settings.registerSetting<SlipDirectionSetting>("direction", direction_,
                                                   ellipsoid::SlipDirection::displacement);
  }

  void postSettings(IContactHistorySetup*, ContactModelBase*) {}

  void connectToProperties(PropertyRegistry& registry) {
    registry.registerProperty("coeffFrict", &MODEL_PARAMS::createCoeffFrict);
    registry.registerProperty("viscousDampingTangential",
                              &ellipsoid_host::viscous_damping_tangential,
                              "tangential history/viscous");
    registry.connect("coeffFrict", friction_, "tangential history/viscous");
    registry.connect("viscousDampingTangential", damping_, "tangential history/viscous");
  }

  inline void surfacesIntersect(const SurfacesIntersectData& sidata, ForceData& i_forces,
                                ForceData& j_forces) {
    if (sidata.contact_flags)
      *sidata.contact_flags |= CONTACT_TANGENTIAL_MODEL;
    double* const stored = &sidata.contact_history[spring_offset_];
    ellipsoid::Vector3 spring{stored[0], stored[1], stored[2]};
    const ellipsoid::Vector3 normal{sidata.en[0], sidata.en[1], sidata.en[2]};
    const ellipsoid::Vector3 velocity{sidata.vtr1, sidata.vtr2, sidata.vtr3};
    const bool update_history = sidata.computeflag && sidata.shearupdate;
    if (update_history)
      Displacement::advance(spring, velocity, update->dt, normal); // the same in both directions
    const ellipsoid::Vector3 force = direction_ == ellipsoid::SlipDirection::velocity
                                         ? friction<Velocity>(sidata, velocity, spring)
                                         : friction<Displacement>(sidata, velocity, spring);
    if (update_history) {
      stored[0] = spring.x;
      stored[1] = spring.y;
      stored[2] = spring.z;
    }
    ellipsoid_host::add_contact_force(sidata, atom->x, force,
                                      ellipsoid_host::TorqueArm::along_normal_on_spheres, i_forces,
                                      j_forces);
  }

  inline void surfacesClose(SurfacesCloseData& scdata, ForceData&, ForceData&) {
    if (scdata.contact_flags)
      *scdata.contact_flags &= ~CONTACT_TANGENTIAL_MODEL;
    if (!scdata.contact_history)
      return;
    for (int k = 0; k < 3; ++k)
      scdata.contact_history[spring_offset_ + k] = 0.0;
  }

  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) {}

 private:
  using Displacement = ellipsoid::HistoryViscous<ellipsoid::SlipDirection::displacement>;
  using Velocity = ellipsoid::HistoryViscous<ellipsoid::SlipDirection::velocity>;

  template <class Law>
  ellipsoid::Vector3 friction(const SurfacesIntersectData& sidata,
                              const ellipsoid::Vector3& velocity,
                              ellipsoid::Vector3& spring) const {
    const ellipsoid::NormalResponse normal{sidata.Fn, sidata.kn, sidata.gamman, sidata.kt,
                                           sidata.gammat};
    double** const tables[] = {friction_, damping_};
    return Law::force(
        ellipsoid::SlidingContact<ellipsoid::Vector3>{normal, sidata.meff, velocity},
        [&](int parameter) { return tables[parameter][sidata.itype][sidata.jtype]; }, spring);
  }

  double** friction_ = nullptr; // mu per type pair
  double** damping_ = nullptr;  // eta_t per type pair (1/time)
  int spring_offset_ = 0;
  ellipsoid::SlipDirection direction_ = ellipsoid::SlipDirection::displacement;
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
#endif
