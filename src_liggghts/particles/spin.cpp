// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "spin.h"

#include "atom.h"
#include "atom_vec_granular_ellipsoid.h"
#include "domain.h"
#include "ellipsoid_host.h"
#include "force.h"
#include "lammps.h"
#include "motion/rigid_body.h"
#include "region.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;
using ellipsoid::Quaternion;
using ellipsoid::SymmetricMatrix3;
using ellipsoid::Vector3;

namespace ellipsoid_host {

namespace {

/// Calls action(i) for the particles of a group, where they are ellipsoids.
template <class Action>
void for_each_of(LAMMPS* lmp, int groupbit, int region, const Action& action) {
  if (!are_ellipsoids(lmp))
    return;
  Atom& atom = *lmp->atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    const double* x = atom.x[i];
    if ((atom.mask[i] & groupbit) &&
        (region < 0 || lmp->domain->regions[region]->match(x[0], x[1], x[2])))
      action(i);
  }
}

} // namespace

bool are_ellipsoids(const LAMMPS* lmp) {
  return dynamic_cast<const AtomVecGranularEllipsoid*>(lmp->atom->avec) != nullptr;
}

void follow_omega(Atom& atom, int i) {
  store(ellipsoid::angular_momentum(vector(atom.omega[i]), vector(atom.inertia[i]),
                                    quaternion(atom.quaternion[i])),
        atom.angmom[i]);
}

void follow_angular_momentum(Atom& atom, int i) {
  store(ellipsoid::angular_velocity(vector(atom.angmom[i]), vector(atom.inertia[i]),
                                    quaternion(atom.quaternion[i])),
        atom.omega[i]);
}

Quaternion turn_about(const Vector3& axis, double angle) {
  const Vector3 part = std::sin(0.5 * angle) * normalized(axis);
  return {std::cos(0.5 * angle), part.x, part.y, part.z};
}

void omega_was_written(LAMMPS* lmp, int i) {
  if (are_ellipsoids(lmp))
    follow_omega(*lmp->atom, i);
}

void slow_spin(LAMMPS* lmp, int i, const double* omega) {
  if (!are_ellipsoids(lmp))
    return;
  store(vector(lmp->atom->omega[i]) - vector(omega), lmp->atom->omega[i]);
  follow_omega(*lmp->atom, i);
}

void turn_with(LAMMPS* lmp, int groupbit, double angular_velocity, const double* axis) {
  Atom& atom = *lmp->atom;
  const bool turns = angular_velocity != 0.0;
  const Vector3 omega = turns ? angular_velocity * vector(axis) : Vector3{};
  const Quaternion turn =
      turns ? turn_about(vector(axis), angular_velocity * lmp->update->dt) : Quaternion{};
  for_each_of(lmp, groupbit, -1, [&](int i) {
    if (turns)
      store(normalized(turn * quaternion(atom.quaternion[i])), atom.quaternion[i]);
    store(omega, atom.omega[i]);
    follow_omega(atom, i);
  });
}

double rotational_energy_of(LAMMPS* lmp, int groupbit, int region) {
  const Atom& atom = *lmp->atom;
  double energy = 0.0, sum = 0.0;
  for_each_of(lmp, groupbit, region, [&](int i) {
    energy += ellipsoid::rotational_energy(vector(atom.angmom[i]), vector(atom.inertia[i]),
                                           quaternion(atom.quaternion[i]));
  });
  MPI_Allreduce(&energy, &sum, 1, MPI_DOUBLE, MPI_SUM, lmp->world);
  return lmp->force->mvv2e * sum;
}

SpinOfGroup::~SpinOfGroup() {
  Vector3 spin;
  for_each_of(lmp_, groupbit_, region_, [&](int i) { spin += vector(of_each_[i]); });
  double mine[3], all[3];
  store(spin, mine);
  MPI_Allreduce(mine, all, 3, MPI_DOUBLE, MPI_SUM, lmp_->world);
  for (int k = 0; k < 3; ++k)
    sum_[k] += all[k];
}

MomentsOfGroup::~MomentsOfGroup() {
  const Atom& atom = *lmp_->atom;
  SymmetricMatrix3 moments;
  for_each_of(lmp_, groupbit_, region_, [&](int i) {
    const double* m = atom.inertia[i];
    moments =
        moments + rotated_diagonal(rotation(quaternion(atom.quaternion[i])), m[0], m[1], m[2]);
  });
  const double mine[6] = {moments.xx, moments.yy, moments.zz, moments.xy, moments.xz, moments.yz};
  double all[6];
  MPI_Allreduce(mine, all, 6, MPI_DOUBLE, MPI_SUM, lmp_->world);
  const int entry[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (int k = 0; k < 6; ++k) {
    const int row = entry[k][0], column = entry[k][1];
    sum_[row][column] += all[k];
    if (row != column)
      sum_[column][row] += all[k];
  }
}

} // namespace ellipsoid_host
