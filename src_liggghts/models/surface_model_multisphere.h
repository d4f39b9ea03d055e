// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Surface model multisphere: contacts of multi-sphere ellipsoids. As for surface smooth, the
// geometry is found by pair_style gran/ellipsoid and fix wall/gran/ellipsoid.
#ifdef SURFACE_MODEL
// clang-format off
SURFACE_MODEL(SURFACE_MULTISPHERE,multisphere,41)
// clang-format on
#else
#ifndef SURFACE_MODEL_MULTISPHERE_H_
#define SURFACE_MODEL_MULTISPHERE_H_

#include "contact_models.h"
#include "ellipsoid_surface.h"
#include "multisphere/multisphere_contact.h"
#include "strict_settings.h"
#include "surface_model_base.h"

namespace LIGGGHTS {
namespace ContactModels {

/// Keyword `multicontact sum|average`.
class MulticontactSetting : public EnumSetting<ellipsoid::MulticontactRule> {
 public:
  MulticontactSetting(std::string name, ellipsoid::MulticontactRule)
      : EnumSetting<ellipsoid::MulticontactRule>(name) {
    addOption("sum", ellipsoid::MulticontactRule::sum);
    addOption("average", ellipsoid::MulticontactRule::average);
    setDefault("sum");
  }
};

template <> class SurfaceModel<SURFACE_MULTISPHERE> : public EllipsoidSurface {
 public:
  SurfaceModel(LAMMPS* lmp, IContactHistorySetup* hsetup, class ContactModelBase* cmb)
      : EllipsoidSurface(lmp, hsetup, cmb, "multisphere") {}

  inline void registerSettings(Settings& settings) {
    settings.registerSetting<ContactsSetting>("contacts", contacts_, ContactsSetting::standard);
    settings.registerSetting<MulticontactSetting>("multicontact", rule_,
                                                  ellipsoid::MulticontactRule::sum);
  }

  /// The callers ask for these two by the only way that the host's classes offer: named integers.
  inline void postSettings(IContactHistorySetup*, ContactModelBase* cmb) {
    cmb->add_history_offset("contacts", contacts_);
    cmb->add_history_offset("multicontact", rule_ == ellipsoid::MulticontactRule::average ? 1 : 0);
  }

 private:
  int contacts_ = ContactsSetting::standard;
  ellipsoid::MulticontactRule rule_ = ellipsoid::MulticontactRule::sum;
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
#endif
