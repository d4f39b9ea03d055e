// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Normal contact model hertz/viscous: eq. (23) of Markauskas et al. 2010 on any surface.
#ifdef NORMAL_MODEL
// clang-format off
NORMAL_MODEL(HERTZ_VISCOUS,hertz/viscous,40)
// clang-format on
#else
#ifndef NORMAL_MODEL_HERTZ_VISCOUS_H_
#define NORMAL_MODEL_HERTZ_VISCOUS_H_

#include "atom.h"
#include "contact_models.h"
#include "ellipsoid_host.h"
#include "global_properties.h"
#include "law/contact_law.h"
#include "normal_model_base.h"

#include <cmath>

namespace LIGGGHTS {
namespace ContactModels {

template <> class NormalModel<HERTZ_VISCOUS> : public NormalModelBase {
 public:
  NormalModel(LAMMPS* lmp, IContactHistorySetup* hsetup, class ContactModelBase* c)
      : NormalModelBase(lmp, hsetup, c) {}

  void registerSettings(Settings& settings) {
    settings.registerOnOff("limitForce", limit_force_, false);
  }

  /// Named integers are the only way that the host's classes offer to ask for a setting.
  void postSettings(IContactHistorySetup*, ContactModelBase* cmb) {
    cmb->add_history_offset("limitForce", limit_force_);
  }

  void connectToProperties(PropertyRegistry& registry) {
    registry.registerProperty("Yeff", &MODEL_PARAMS::createYeff, "model hertz/viscous");
    registry.registerProperty("Geff", &MODEL_PARAMS::createGeff, "model hertz/viscous");
    registry.registerProperty("viscousDampingNormal", &ellipsoid_host::viscous_damping_normal,
                              "model hertz/viscous");
    registry.connect("Yeff", effective_modulus_, "model hertz/viscous");
    registry.connect("Geff", effective_shear_modulus_, "model hertz/viscous");
    registry.connect("viscousDampingNormal", damping_, "model hertz/viscous");
  }

  /// Force ~ overlap^1.5.
  double stressStrainExponent() { return 1.5; }

  inline void surfacesIntersect(SurfacesIntersectData& sidata, ForceData& i_forces,
                                ForceData& j_forces) {
    if (sidata.contact_flags)
      *sidata.contact_flags |= CONTACT_NORMAL_MODEL;
    const int itype = sidata.itype, jtype = sidata.jtype;
    const double radius = ellipsoid_host::reduced_radius(sidata);
    const double root = std::sqrt(radius * sidata.deltan);
    sidata.kn = ellipsoid::normal_stiffness(effective_modulus_[itype][jtype], root);
    sidata.kt = ellipsoid::tangential_stiffness(effective_shear_modulus_[itype][jtype], root);
    sidata.gamman = damping_[itype][jtype] * sidata.meff;
    sidata.gammat = 0.0;
    sidata.Fn = sidata.kn * sidata.deltan - sidata.gamman * sidata.vn; // eq. 23
    if (limit_force_ && sidata.Fn < 0.0)
      sidata.Fn = 0.0;
    ellipsoid_host::add_contact_force(
        sidata, atom->x,
        {sidata.Fn * sidata.en[0], sidata.Fn * sidata.en[1], sidata.Fn * sidata.en[2]},
        ellipsoid_host::TorqueArm::none_on_spheres, i_forces, j_forces);
  }

  inline void surfacesClose(SurfacesCloseData& scdata, ForceData&, ForceData&) {
    if (scdata.contact_flags)
      *scdata.contact_flags &= ~CONTACT_NORMAL_MODEL;
  }

  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) {}

 private:
  double** effective_modulus_ = nullptr;       // E* per type pair (pressure)
  double** effective_shear_modulus_ = nullptr; // G* per type pair (pressure)
  double** damping_ = nullptr;                 // eta_n per type pair (1/time)
  bool limit_force_ = false;
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
#endif
