// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix nve/ellipsoid: motion of ellipsoids by eqs. (11) to (13) of Markauskas et al. 2010.
#ifdef FIX_CLASS
FixStyle(nve/ellipsoid,FixNVEEllipsoid)
#else
#ifndef LMP_FIX_NVE_ELLIPSOID_H
#define LMP_FIX_NVE_ELLIPSOID_H

#include "fix_nve.h"
#include "rotation_batch.h"

namespace LAMMPS_NS {

/// Velocity Verlet for the translation, half a kick of the torque, a torque-free turn by symmetric
/// splitting, half a kick of the torque for the rotation: second order.
class FixNVEEllipsoid : public FixNVE {
public:
  FixNVEEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  void init() override;
  void initial_integrate(int vflag) override;
  void final_integrate() override;
  void initial_integrate_respa(int vflag, int level, int loop) override;
  void final_integrate_respa(int level, int loop) override;
  void reset_dt() override;

private:
  bool planar_ = false; // motion in the xy plane only
  ellipsoid::RotationBatch turns_;
  int turning_[ellipsoid::RotationBatch::capacity]; // particles of the batch

  void kick(int i) const;
  void keep_in_plane(int i) const;
  void turn(int i);
  void turn_waiting();
  void turn_in_plane(int i) const;
};

} // namespace LAMMPS_NS

#endif
#endif
