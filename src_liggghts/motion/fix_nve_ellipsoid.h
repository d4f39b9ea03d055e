// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix nve/ellipsoid: motion of ellipsoids by eqs. (11) to (13) of Markauskas et al. 2010.
#ifdef FIX_CLASS
// clang-format off
FixStyle(nve/ellipsoid,FixNVEEllipsoid)
// clang-format on
#else
#ifndef LMP_FIX_NVE_ELLIPSOID_H
#define LMP_FIX_NVE_ELLIPSOID_H

#include "fix_nve.h"
#include "motion/planar_motion.h"
#include "motion/rotation_batch.h"
#include "particle_arrays.h"

#include <cstddef>
#include <vector>

namespace ellipsoid {
class Gear;
struct Vector3;
} // namespace ellipsoid

namespace LAMMPS_NS {

/// `integrator verlet`: velocity Verlet for the translation, half a kick of the torque, a
/// torque-free turn by symmetric splitting, half a kick of the torque for the rotation: second
/// order. `integrator gear`: Gear's predictor-corrector for the positions and for the quaternions
/// (for the angle, when planar); the derivatives are kept per atom in two fixes property/atom.
class FixNVEEllipsoid : public FixNVE {
 public:
  FixNVEEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  void post_create() override;
  void pre_delete(bool unfixed) override;
  void init() override;
  void setup(int vflag) override;
  void initial_integrate(int vflag) override;
  void final_integrate() override;
  void initial_integrate_respa(int vflag, int level, int loop) override;
  void final_integrate_respa(int level, int loop) override;
  void reset_dt() override;

 private:
  bool planar_ = false; // motion in the xy plane only
  ellipsoid::RotationBatch turns_;
  int turning_[ellipsoid::RotationBatch::capacity]; // particles of the batch
  // One over the principal moments about the body's axes (planar: about z) of all particles that
  // move; they keep their indices until lists are new.
  std::vector<double> inverse_inertia_;
  bool gear_ = false;
  // of `integrator gear`, per atom: started (1) or not (0), then second to fifth derivative of x,
  // y, z
  class FixPropertyAtom* translation_ = nullptr;
  // second to fifth derivative of the quaternion's w, x, y, z (planar: of the angle)
  class FixPropertyAtom* rotation_ = nullptr;

  template <class Action> void for_each_atom(Action action) const;
  template <class Step> void step_in_plane(int i, Step step) const;
  class FixPropertyAtom* find_derivatives(const char* what) const;
  void turn_waiting(const ellipsoid_host::ParticleArrays& particles);
  std::size_t inverse_inertia_size() const;
  void know_inertia();
  int candidate_count() const;
  ellipsoid::PlanarRows planar_rows() const;
  void start_step_in_space();
  void end_step_in_space();
  double inertia_about_z(int i) const;
  void start(int i) const;
  void predict(int i, const ellipsoid::Gear& gear) const;
  void correct(int i, const ellipsoid::Gear& gear) const;
  void correct_rotation(int i, const ellipsoid::Gear& gear) const;
  void store_spin(int i, const ellipsoid::Vector3& omega) const;
};

} // namespace LAMMPS_NS

#endif
#endif
