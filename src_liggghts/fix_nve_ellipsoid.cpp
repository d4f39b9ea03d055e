// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_nve_ellipsoid.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "force.h"
#include "update.h"

#include <string>

using namespace LAMMPS_NS;
using ellipsoid_host::quaternion;
using ellipsoid_host::store;
using ellipsoid_host::vector;

namespace {

/// Sine^2 of the angle between z and inertia times z that counts as a principal axis: far above
/// the rounding of a long run, far below what a user could mean.
constexpr double largest_misalignment = 1e-10;

} // namespace

FixNVEEllipsoid::FixNVEEllipsoid(LAMMPS* lmp, int narg, char** arg) : FixNVE(lmp, narg, arg) {
  ellipsoid_host::ArgumentReader reader(error, this, narg, arg, 3);
  while (!reader.done()) {
    const std::string keyword = reader.keyword();
    if (keyword == "planar")
      planar_ = reader.yes_no(keyword);
    else
      reader.complain("unknown keyword '" + keyword + "', allowed is 'planar'");
  }
}

void FixNVEEllipsoid::init() {
  FixNVE::init();
  if (!atom->superquadric_flag)
    error->fix_error(FLERR, this, "needs particles with shape: use atom_style granular/ellipsoid");
}

void FixNVEEllipsoid::reset_dt() {
  dtv = update->dt;
  dtf = 0.5 * update->dt * force->ftm2v;
}

/// Half a time step of force and torque.
void FixNVEEllipsoid::kick(int i) const {
  const double* f = atom->f[i];
  const double* torque = atom->torque[i];
  double* v = atom->v[i];
  double* momentum = atom->angmom[i];
  const double scale = dtf / atom->rmass[i];
  for (int k = 0; k < 3; ++k) {
    v[k] += scale * f[k];
    momentum[k] += dtf * torque[k];
  }
}

/// Takes out what rounding (or a force out of the plane) has put in.
void FixNVEEllipsoid::keep_in_plane(int i) const {
  atom->f[i][2] = atom->v[i][2] = 0.0;
  for (int k = 0; k < 2; ++k)
    atom->torque[i][k] = atom->angmom[i][k] = atom->omega[i][k] = 0.0;
}

/// Particles turn together with others: as soon as the batch is full, at the latest in turn_waiting().
void FixNVEEllipsoid::turn(int i) {
  turning_[turns_.size()] = i;
  turns_.add(quaternion(atom->quaternion[i]), vector(atom->angmom[i]), vector(atom->inertia[i]));
  if (turns_.full())
    turn_waiting();
}

void FixNVEEllipsoid::turn_waiting() {
  turns_.solve(dtv);
  for (int k = 0; k < turns_.size(); ++k) {
    store(turns_.orientation(k), atom->quaternion[turning_[k]]);
    store(turns_.omega(k), atom->omega[turning_[k]]);
  }
  turns_.clear();
}

void FixNVEEllipsoid::turn_in_plane(int i) const {
  const auto q = quaternion(atom->quaternion[i]);
  const ellipsoid::PlanarInertia inertia = planar_inertia(q, vector(atom->inertia[i]));
  if (inertia.misaligned > largest_misalignment)
    error->one(FLERR, ("Fix nve/ellipsoid (id " + std::string(id) + "): planar yes, but atom " +
                       std::to_string(atom->tag[i]) +
                       " has no principal axis along z; insert it with orientation planar, or set "
                       "its quaternion")
                          .c_str());
  const double rate = atom->angmom[i][2] / inertia.about_z;
  store(rotate_about_z(q, dtv * rate), atom->quaternion[i]);
  atom->omega[i][2] = rate;
}

void FixNVEEllipsoid::initial_integrate(int) {
  const int count = igroup == atom->firstgroup ? atom->nfirst : atom->nlocal;
  for (int i = 0; i < count; ++i) {
    if (!(atom->mask[i] & groupbit))
      continue;
    kick(i);
    if (planar_)
      keep_in_plane(i);
    for (int k = 0; k < 3; ++k)
      atom->x[i][k] += dtv * atom->v[i][k];
    if (planar_)
      turn_in_plane(i);
    else
      turn(i);
  }
  turn_waiting();
}

void FixNVEEllipsoid::final_integrate() {
  const int count = igroup == atom->firstgroup ? atom->nfirst : atom->nlocal;
  for (int i = 0; i < count; ++i) {
    if (!(atom->mask[i] & groupbit))
      continue;
    kick(i);
    if (planar_) {
      keep_in_plane(i);
      const auto inertia =
          planar_inertia(quaternion(atom->quaternion[i]), vector(atom->inertia[i]));
      atom->omega[i][2] = atom->angmom[i][2] / inertia.about_z;
    } else {
      store(angular_velocity(vector(atom->angmom[i]), vector(atom->inertia[i]),
                             quaternion(atom->quaternion[i])),
            atom->omega[i]);
    }
  }
}

void FixNVEEllipsoid::initial_integrate_respa(int, int, int) {
  error->fix_error(FLERR, this, "does not work with run_style respa; use run_style verlet");
}

void FixNVEEllipsoid::final_integrate_respa(int, int) {
  error->fix_error(FLERR, this, "does not work with run_style respa; use run_style verlet");
}
