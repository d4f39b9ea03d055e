// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix check/timestep/ellipsoid: the time step as a fraction of Rayleigh's and Hertz's time.
#ifdef FIX_CLASS
// clang-format off
FixStyle(check/timestep/ellipsoid,FixCheckTimestepEllipsoid)
// clang-format on
#else
#ifndef LMP_FIX_CHECK_TIMESTEP_ELLIPSOID_H
#define LMP_FIX_CHECK_TIMESTEP_ELLIPSOID_H

#include "fix.h"

#include <memory>
#include <string>

namespace ellipsoid_host {
class MultisphereParticles;
}

namespace LAMMPS_NS {

/// Global vector: time step over the smallest Rayleigh time, time step over the shortest duration
/// of a collision, largest relative way in a step over the skin.
class FixCheckTimestepEllipsoid : public Fix {
 public:
  FixCheckTimestepEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  ~FixCheckTimestepEllipsoid() override;
  int setmask() override;
  void init() override;
  /// Warns of a time step that is far too long before particles fly apart.
  void setup(int) override;
  void end_of_step() override;
  double compute_vector(int n) override { return fractions_[n]; }

  /// Makes one for scripts that have none of their own. It warns once, and stops where particles
  /// touch and a collision would be over within a step.
  static void make_sure(LAMMPS* lmp);

 private:
  enum { rayleigh, hertz, skin };      // fractions
  double limits_[3] = {0.0, 0.0, 1.0}; // of the fractions
  double fractions_[3] = {0.0, 0.0, 0.0};
  bool warns_ = true, stops_ = false;
  double largest_speed_ = 0.0;  // given by the user (length/time)
  bool is_default_ = false;     // made by make_sure()
  bool is_superfluous_ = false; // the script has one of its own, or laws without Hertz's constants
  class FixPropertyGlobal* youngs_modulus_ = nullptr;
  class FixPropertyGlobal* poissons_ratio_ = nullptr;
  std::unique_ptr<ellipsoid_host::MultisphereParticles> chains_;

  void parse(int narg, char** arg);
  void check_material() const;
  /// E* of a particle of this type with the stiffest partner (force/length^2).
  double effective_modulus(int type) const;
  double rayleigh_time(int i, bool multisphere, double shear_modulus, double ratio);
  double smallest_mass2_over_radius(int i, bool multisphere);
  void measure();
  double contacts() const;
  void report(int which, const std::string& of_what);
};

} // namespace LAMMPS_NS

#endif
#endif
