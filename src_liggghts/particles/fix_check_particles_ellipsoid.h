// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix check/particles/ellipsoid: finds particles that cannot be simulated.
#ifdef FIX_CLASS
// clang-format off
FixStyle(check/particles/ellipsoid,FixCheckParticlesEllipsoid)
// clang-format on
#else
#ifndef LMP_FIX_CHECK_PARTICLES_ELLIPSOID_H
#define LMP_FIX_CHECK_PARTICLES_ELLIPSOID_H

#include "fix.h"

namespace LAMMPS_NS {

/// Made by atom_style granular/ellipsoid itself. Looks at every particle when a run is set up and
/// whenever neighbour lists are new (so at each that has been inserted or has changed its rank),
/// and for numbers that are not finite every few steps and before each output.
class FixCheckParticlesEllipsoid : public Fix {
 public:
  FixCheckParticlesEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void pre_exchange() override;
  void pre_neighbor() override;
  void end_of_step() override;

  /// Adds the fix, unless it is there.
  static void make_sure(class LAMMPS* lmp);

 private:
  bool warned_of_none_ = false, warned_of_two_ = false; // in this run
  bigint counted_ = 0; // particles at the last check of integrators

  void check_integrators();
};

} // namespace LAMMPS_NS

#endif
#endif
