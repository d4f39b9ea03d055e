// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Surface model smooth: contacts of smooth ellipsoids. The geometry (normal, contact point, overlap,
// reduced radius) is found by pair_style gran/ellipsoid and fix wall/gran/ellipsoid before the
// contact models are called; what is left here is the relative motion at the contact point, and, on
// demand, the radius that Hertz's solution for elliptic contacts takes.
#ifdef SURFACE_MODEL
SURFACE_MODEL(SURFACE_SMOOTH,smooth,40)
#else
#ifndef SURFACE_MODEL_SMOOTH_H_
#define SURFACE_MODEL_SMOOTH_H_

#include "contact_models.h"
#include "ellipsoid_contact.h"
#include "ellipsoid_host.h"
#include "ellipsoid_surface.h"
#include "surface_model_base.h"

namespace LIGGGHTS {
namespace ContactModels {

template <> class SurfaceModel<SURFACE_SMOOTH> : public EllipsoidSurface {
public:
  SurfaceModel(LAMMPS* lmp, IContactHistorySetup* hsetup, class ContactModelBase* cmb)
      : EllipsoidSurface(lmp, hsetup, cmb, "smooth") {}

  inline void registerSettings(Settings& settings) {
    settings.registerOnOff("ellipticalContact", elliptical_, false);
  }

  inline void surfacesIntersect(SurfacesIntersectData& sidata, ForceData& i_forces,
                                ForceData& j_forces) {
    if (elliptical_)
      take_ellipse(sidata);
    EllipsoidSurface::surfacesIntersect(sidata, i_forces, j_forces);
  }

private:
  bool elliptical_ = false;

  ellipsoid::EllipsoidShape shape(int i) const {
    return ellipsoid::make_shape(ellipsoid_host::vector(atom->shape[i]),
                                 ellipsoid_host::quaternion(atom->quaternion[i]));
  }

  /// Replaces the radius of (19) by that of the elliptic contact. Walls count as flat here: where
  /// they are not, their reduced radius is corrected in the same ratio.
  void take_ellipse(SurfacesIntersectData& sidata) {
    const ellipsoid::Vector3 normal = -ellipsoid_host::vector(sidata.en);
    const ellipsoid::RelativeCurvature curvature =
        sidata.is_wall ? relative_curvature(shape(sidata.i), normal)
                       : relative_curvature(shape(sidata.i), shape(sidata.j), normal);
    const ellipsoid::EllipticContact contact = elliptic_hertz(curvature);
    const double factor = contact.effective_radius / circle_radius(curvature);
    sidata.reff *= factor;
    caller().curvature_radius_i *= factor;
    caller().curvature_radius_j *= factor;
    caller().area_factor = contact.area_per_overlap / (M_PI * contact.effective_radius);
  }
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
#endif
