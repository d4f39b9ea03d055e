// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Surface model multisphere: contacts of multi-sphere ellipsoids. As for surface smooth, the
// geometry is found by pair_style gran/ellipsoid and fix wall/gran/ellipsoid.
#ifdef SURFACE_MODEL
// clang-format off
SURFACE_MODEL(SURFACE_MULTISPHERE,multisphere,41)
// clang-format on
#else
#ifndef LMP_SURFACE_MODEL_MULTISPHERE_H
#define LMP_SURFACE_MODEL_MULTISPHERE_H

#include "contact_models.h"
#include "ellipsoid_surface.h"
#include "multisphere/multisphere_contact.h"
#include "surface_model_base.h"
#include "surface_settings.h"

namespace LIGGGHTS {
namespace ContactModels {

template <> class SurfaceModel<SURFACE_MULTISPHERE> : public EllipsoidSurface {
 public:
  SurfaceModel(LAMMPS* lmp, IContactHistorySetup* hsetup, class ContactModelBase* cmb)
      : EllipsoidSurface(lmp, hsetup, cmb, "multisphere") {}

  inline void registerSettings(Settings& settings) {
    settings.registerSetting<ContactsSetting>("contacts", contacts_, ContactsSetting::standard);
    settings.registerSetting<MulticontactSetting>("multicontact", rule_,
                                                  ellipsoid::MulticontactRule::sum);
  }

 private:
  // where the host puts what it parsed; who finds the contacts reads it from the command
  int contacts_ = ContactsSetting::standard;
  ellipsoid::MulticontactRule rule_ = ellipsoid::MulticontactRule::sum;
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
#endif
