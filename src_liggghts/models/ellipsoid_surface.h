// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the surface models of ellipsoids share.
#pragma once

#include "contact_models.h"

#include "atom.h"
#include "ellipsoid_contact_caller.h"
#include "ellipsoid_host.h"
#include "math_extra_liggghts_nonspherical.h"
#include "surface_model_base.h"

#include <string>

namespace LIGGGHTS {
namespace ContactModels {

class EllipsoidSurface : public SurfaceModelBase {
 public:
  EllipsoidSurface(LAMMPS* lmp, IContactHistorySetup* hsetup, class ContactModelBase* cmb,
                   const char* name)
      : SurfaceModelBase(lmp, hsetup, cmb), setup_(hsetup), name_(name) {}

  inline void registerSettings(Settings&) {}
  inline void postSettings(IContactHistorySetup*, ContactModelBase*) {}

  // here the caller is complete: the host constructs its base class first
  inline void connectToProperties(PropertyRegistry&) {
    caller_ = dynamic_cast<EllipsoidContactCaller*>(setup_);
    if (!caller_)
      error->all(FLERR, ("surface " + name_ +
                         " works with pair_style gran/ellipsoid and fix wall/gran/ellipsoid only; "
                         "use these, or another surface")
                            .c_str());
  }

  inline bool checkSurfaceIntersect(SurfacesIntersectData& sidata) { return sidata.deltan >= 0.0; }

  inline void surfacesIntersect(SurfacesIntersectData& sidata, ForceData&, ForceData&) {
    set_local_spheres(sidata);
    MathExtraLiggghtsNonspherical::surfacesIntersectNonSpherical(sidata, atom->x);
  }

  /// Called when all models have added to the force.
  inline void endSurfacesIntersect(SurfacesIntersectData& sidata, TriMesh* mesh,
                                   double* const force) {
    if (sidata.computeflag && caller_->keeps_records())
      caller_->add_record(sidata, ellipsoid_host::vector(force), *atom, mesh);
  }
  inline void surfacesClose(SurfacesCloseData&, ForceData&, ForceData&) {}
  inline void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) {}
  inline void endPass(SurfacesIntersectData&, ForceData&, ForceData&) {}
  inline void tally_pp(double, int, int, int) {}
  inline void tally_pw(double, int, int, int) {}

 protected:
  EllipsoidContactCaller& caller() { return *caller_; }

 private:
  /// Contact models that ask for radii and distances get those of two spheres: with the radii of
  /// curvature at the contact, at the distance that gives its overlap. (The host's wall has filled
  /// in the sphere of equal volume.)
  void set_local_spheres(SurfacesIntersectData& sidata) const {
    sidata.radi = sidata.radsum = caller_->curvature_radius_i;
    if (!sidata.is_wall) {
      sidata.radj = caller_->curvature_radius_j;
      sidata.radsum += sidata.radj;
    }
    sidata.r = sidata.radsum - sidata.deltan;
    sidata.rsq = sidata.r * sidata.r;
    sidata.rinv = 1.0 / sidata.r;
  }

  IContactHistorySetup* setup_;
  std::string name_;
  EllipsoidContactCaller* caller_ = nullptr;
};

} // namespace ContactModels
} // namespace LIGGGHTS
