// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Angular velocity and angular momentum of an ellipsoid belong together, but commands of the host
// write one and not the other, turn centres and not bodies, or add up centres of mass only.
#pragma once

#include "math/vector3.h"

namespace LAMMPS_NS {
class Atom;
class LAMMPS;
class Region;
} // namespace LAMMPS_NS

namespace ellipsoid_host {

/// Is the atom style granular/ellipsoid?
bool are_ellipsoids(const LAMMPS_NS::LAMMPS* lmp);
/// The angular momentum of particle i becomes that of its angular velocity.
void follow_omega(LAMMPS_NS::Atom& atom, int i);
/// The angular velocity of particle i becomes that of its angular momentum.
void follow_angular_momentum(LAMMPS_NS::Atom& atom, int i);
/// A turn by `angle` (rad) about an axis of any length.
ellipsoid::Quaternion turn_about(const ellipsoid::Vector3& axis, double angle);

// --- called by patched files of the host; without ellipsoids these do nothing ---

/// As follow_omega().
void omega_was_written(LAMMPS_NS::LAMMPS* lmp, int i);
/// Takes `omega` (rad/time) off the angular velocity of particle i.
void slow_spin(LAMMPS_NS::LAMMPS* lmp, int i, const double* omega);
/// Turns the bodies of a group by the angle of one step about a unit axis, and lets them have that
/// angular velocity (rad/time).
void turn_with(LAMMPS_NS::LAMMPS* lmp, int groupbit, double angular_velocity, const double* axis);
/// Rotational energy of the particles of a group whose centres lie in a region.
/// @param[in] region its number, -1: everywhere
/// @return over all ranks (energy)
double rotational_energy_of(LAMMPS_NS::LAMMPS* lmp, int groupbit, int region);

/// Adds, at the end of its life, what the bodies themselves have of the angular momentum of a
/// group, or of the torque on it.
class SpinOfGroup {
 public:
  /// @param[in] region  its number, -1: everywhere
  /// @param[in] of_each angular momenta or torques, per particle
  SpinOfGroup(LAMMPS_NS::LAMMPS* lmp, int groupbit, int region, double** of_each, double* sum)
      : lmp_(lmp), groupbit_(groupbit), region_(region), of_each_(of_each), sum_(sum) {}
  ~SpinOfGroup();

 private:
  LAMMPS_NS::LAMMPS* lmp_;
  int groupbit_, region_;
  double** of_each_;
  double* sum_;
};

/// Adds, at the end of its life, what the bodies themselves have of the moments of inertia of a
/// group.
class MomentsOfGroup {
 public:
  MomentsOfGroup(LAMMPS_NS::LAMMPS* lmp, int groupbit, int region, double sum[3][3])
      : lmp_(lmp), groupbit_(groupbit), region_(region), sum_(sum) {}
  ~MomentsOfGroup();

 private:
  LAMMPS_NS::LAMMPS* lmp_;
  int groupbit_, region_;
  double (*sum_)[3];
};

} // namespace ellipsoid_host
