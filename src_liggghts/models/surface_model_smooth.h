// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Surface model smooth: contacts of smooth ellipsoids. The geometry (normal, contact point,
// overlap, reduced radius) is found by pair_style gran/ellipsoid and fix wall/gran/ellipsoid before
// the contact models are called; what is left here is the relative motion at the contact point,
// and, on demand, the radius that Hertz's solution for elliptic contacts takes.
#ifdef SURFACE_MODEL
// clang-format off
SURFACE_MODEL(SURFACE_SMOOTH,smooth,40)
// clang-format on
#else
#ifndef LMP_SURFACE_MODEL_SMOOTH_H
#define LMP_SURFACE_MODEL_SMOOTH_H

#include "contact_models.h"
#include "ellipsoid/ellipsoid_contact.h"
#include "ellipsoid_host.h"
#include "ellipsoid_surface.h"
#include "surface_model_base.h"
#include "surface_settings.h"

#include <cmath>

namespace LIGGGHTS {
namespace ContactModels {

template <> class SurfaceModel<SURFACE_SMOOTH> : public EllipsoidSurface {
 public:
  SurfaceModel(LAMMPS* lmp, IContactHistorySetup* hsetup, class ContactModelBase* cmb)
      : EllipsoidSurface(lmp, hsetup, cmb, "smooth") {}

  inline void registerSettings(Settings& settings) {
    settings.registerOnOff("ellipticalContact", elliptical_, false);
    settings.registerSetting<ContactsSetting>("contacts", contacts_, ContactsSetting::standard);
  }

  inline void surfacesIntersect(SurfacesIntersectData& sidata, ForceData& i_forces,
                                ForceData& j_forces) {
    if (elliptical_) {
      const Ellipse ellipse = find_ellipse(sidata.i, sidata.is_wall ? no_partner : sidata.j,
                                           -ellipsoid_host::vector(sidata.en));
      sidata.reff *= ellipse.radius_factor;
      caller().curvature_radius_i *= ellipse.radius_factor;
      caller().curvature_radius_j *= ellipse.radius_factor;
      caller().area_factor = ellipse.area_factor;
    }
    EllipsoidSurface::surfacesIntersect(sidata, i_forces, j_forces);
  }

 private:
  static constexpr int no_partner = -1;
  bool elliptical_ = false;
  int contacts_ = ContactsSetting::standard; // where the host puts it; walls read it themselves

  struct Ellipse {
    double radius_factor; ///< R of the elliptic contact over that of (19)
    double area_factor;   ///< area over pi R h
  };

  ellipsoid::EllipsoidShape shape(int i) const {
    return ellipsoid::make_shape(ellipsoid_host::vector(atom->shape[i]),
                                 ellipsoid_host::quaternion(atom->quaternion[i]));
  }

  /// Walls count as flat: where they are not, their reduced radius is corrected in the same ratio.
  __attribute__((noinline)) Ellipse find_ellipse(int i, int j, ellipsoid::Vector3 normal) const {
    const ellipsoid::RelativeCurvature curvature =
        j == no_partner ? relative_curvature(shape(i), normal)
                        : relative_curvature(shape(i), shape(j), normal);
    const ellipsoid::EllipticContact contact = elliptic_hertz(curvature);
    return {contact.effective_radius / circle_radius(curvature),
            contact.area_per_overlap / (M_PI * contact.effective_radius)};
  }
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
#endif
