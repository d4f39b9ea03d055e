// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Surface model smooth: contacts of smooth ellipsoids. The geometry (normal, contact point, overlap,
// reduced radius) is found by pair_style gran/ellipsoid and fix wall/gran/ellipsoid before the
// contact models are called; what is left here is the relative motion at the contact point.
#ifdef SURFACE_MODEL
SURFACE_MODEL(SURFACE_SMOOTH,smooth,40)
#else
#ifndef SURFACE_MODEL_SMOOTH_H_
#define SURFACE_MODEL_SMOOTH_H_

#include "contact_models.h"
#include "ellipsoid_surface.h"
#include "strict_settings.h"
#include "surface_model_base.h"

namespace LIGGGHTS {
namespace ContactModels {

template <> class SurfaceModel<SURFACE_SMOOTH> : public EllipsoidSurface {
public:
  SurfaceModel(LAMMPS* lmp, IContactHistorySetup* hsetup, class ContactModelBase* cmb)
      : EllipsoidSurface(lmp, hsetup, cmb, "smooth") {}

  inline void registerSettings(Settings& settings) {
    settings.registerSetting<ContactsSetting>("contacts", contacts_, ContactsSetting::standard);
  }

  /// The only way that the host's classes offer: a named integer. Walls of triangles ask for it.
  inline void postSettings(IContactHistorySetup*, ContactModelBase* cmb) {
    cmb->add_history_offset("contacts", contacts_);
  }

private:
  int contacts_ = ContactsSetting::standard;
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
#endif
