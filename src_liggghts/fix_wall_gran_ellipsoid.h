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

namespace LAMMPS_NS {

/// Takes the arguments of fix wall/gran. The host parses them, keeps the lists of near particles
/// and the history, and applies the contact models; only the geometry is ours.
class FixWallGranEllipsoid : public FixWallGran,
                             public LIGGGHTS::ContactModels::EllipsoidContactCaller {
public:
  FixWallGranEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  void init() override;

protected:
  void post_force_primitive(int vflag) override;

private:
  void plane_contact(int particle, double* history, double* wall_velocity);
};

} // namespace LAMMPS_NS

#endif
#endif
