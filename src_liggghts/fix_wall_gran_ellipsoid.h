// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix wall/gran/ellipsoid: walls with the exact contact geometry of ellipsoids.
#ifdef FIX_CLASS
FixStyle(wall/gran/ellipsoid,FixWallGranEllipsoid)
#else
#ifndef LMP_FIX_WALL_GRAN_ELLIPSOID_H
#define LMP_FIX_WALL_GRAN_ELLIPSOID_H

#include "ellipsoid_contact_caller.h"
#include "fix_wall_gran.h"
#include "multisphere_particles.h"
#include "update.h"

#include <vector>

namespace LAMMPS_NS {

/// Takes the arguments of fix wall/gran. The host parses them, keeps the lists of near particles
/// and the history, and applies the contact models; only the geometry is ours.
class FixWallGranEllipsoid : public FixWallGran,
                             public LIGGGHTS::ContactModels::EllipsoidContactCaller {
public:
  FixWallGranEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  void init() override;
  void post_force(int vflag) override {
    begin_records(update->ntimestep);
    FixWallGran::post_force(vflag);
  }

protected:
  void post_force_primitive(int vflag) override;

private:
  bool multisphere_ = false;
  ellipsoid_host::MultisphereParticles particles_; // for surface multisphere
  std::vector<ellipsoid::SphereContact> found_;
  std::vector<double> slots_before_;
  int slot_values_ = 0, slots_ = 0;
  ellipsoid::MulticontactRule rule_ = ellipsoid::MulticontactRule::sum;

  void smooth_contact(int particle, double* history, double* wall_velocity);
  void multisphere_contacts(int particle, double* history, double* wall_velocity);
  void keep_slots(int particle, double* history);
  LCM::SurfacesIntersectData wall_contact(int particle, const ellipsoid::Vector3& normal,
                                          const ellipsoid::Vector3& point, double overlap,
                                          double radius, double* history);
};

} // namespace LAMMPS_NS

#endif
#endif
