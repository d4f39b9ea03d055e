// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_nve_ellipsoid.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_check_timestep_ellipsoid.h"
#include "fix_property_atom.h"
#include "force.h"
#include "modify.h"
#include "motion/gear_predictor_corrector.h"
#include "motion/rigid_body.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace LAMMPS_NS;
using ellipsoid_host::ParticleArrays;
using ellipsoid_host::quaternion;
using ellipsoid_host::store;
using ellipsoid_host::vector;

namespace {

/// Sine^2 of the angle between z and inertia times z that counts as a principal axis: far above
/// the rounding of a long run, far below what a user could mean.
constexpr double largest_misalignment = 1e-10;

constexpr int derivative_count = 4; // of each coordinate: second to fifth
constexpr int translation_values = 1 + 3 * derivative_count, rotation_values = 4 * derivative_count;

ellipsoid::Quaternion turned_about_z(const ellipsoid::Quaternion& q, double angle) {
  return normalized(ellipsoid::Quaternion{std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle)} *
                    q);
}

/// Half a time step of force and torque.
inline void kick(const ParticleArrays& p, int i, double half_step) {
  const double *f = p.f[i], *torque = p.torque[i], scale = half_step / p.mass[i];
  double *v = p.v[i], *momentum = p.angmom[i];
  for (int k = 0; k < 3; ++k) {
    v[k] += scale * f[k];
    momentum[k] += half_step * torque[k];
  }
}

/// Takes out what rounding (or a force out of the plane) has put in.
inline void keep_in_plane(const ParticleArrays& p, int i) {
  p.v[i][2] = p.omega[i][0] = p.omega[i][1] = p.f[i][2] = 0.0;
  for (int k = 0; k < 2; ++k)
    p.torque[i][k] = p.angmom[i][k] = 0.0;
}

} // namespace

FixNVEEllipsoid::FixNVEEllipsoid(LAMMPS* lmp, int narg, char** arg) : FixNVE(lmp, narg, arg) {
  ellipsoid_host::ArgumentReader reader(error, this, narg, arg, 3);
  while (!reader.done()) {
    const std::string keyword = reader.keyword();
    if (keyword == "planar")
      planar_ = reader.yes_no(keyword);
    else if (keyword == "integrator")
      gear_ = reader.choice(keyword, {"verlet", "gear"}) == 1;
    else
      reader.complain("unknown keyword '" + keyword + "', allowed are 'planar', 'integrator'");
  }
}

FixPropertyAtom* FixNVEEllipsoid::find_derivatives(const char* what) const {
  const std::string name = std::string("gear_") + what + "_" + id;
  return static_cast<FixPropertyAtom*>(
      modify->find_fix_property(name.c_str(), "property/atom", "vector", 0, 0, style, false));
}

/// The derivatives go with the atoms to other ranks and to restart files.
void FixNVEEllipsoid::post_create() {
  FixCheckTimestepEllipsoid::make_sure(lmp);
  if (!gear_)
    return;
  for (const auto& [what, count] : {std::make_pair("translation", translation_values),
                                    std::make_pair("rotation", rotation_values)}) {
    if (find_derivatives(what))
      continue;
    const std::string name = std::string("gear_") + what + "_" + id;
    std::vector<const char*> arguments{
        name.c_str(), "all", "property/atom", name.c_str(), "vector", "yes", "no", "no"};
    arguments.insert(arguments.end(), static_cast<std::size_t>(count), "0.");
    modify->add_fix(static_cast<int>(arguments.size()), const_cast<char**>(arguments.data()));
  }
}

void FixNVEEllipsoid::pre_delete(bool unfixed) {
  if (!gear_ || !unfixed)
    return;
  for (const char* what : {"translation", "rotation"})
    if (const FixPropertyAtom* derivatives = find_derivatives(what))
      modify->delete_fix(derivatives->id);
}

void FixNVEEllipsoid::init() {
  FixNVE::init();
  if (!atom->superquadric_flag)
    error->fix_error(FLERR, this, "needs particles with shape: use atom_style granular/ellipsoid");
  if (gear_) {
    translation_ = find_derivatives("translation");
    rotation_ = find_derivatives("rotation");
  }
}

/// All particles of the group are among the first so many.
int FixNVEEllipsoid::candidate_count() const {
  return igroup == atom->firstgroup ? atom->nfirst : atom->nlocal;
}

template <class Action> void FixNVEEllipsoid::for_each_atom(Action action) const {
  const int count = candidate_count();
  for (int i = 0; i < count; ++i)
    if (atom->mask[i] & groupbit)
      action(i);
}

void FixNVEEllipsoid::setup(int) {
  if (gear_)
    for_each_atom([this](int i) {
      if (translation_->array_atom[i][0] == 0.0)
        start(i);
    });
  else
    know_inertia();
}

void FixNVEEllipsoid::reset_dt() {
  dtv = update->dt;
  dtf = 0.5 * update->dt * force->ftm2v;
}

void FixNVEEllipsoid::turn_waiting(const ParticleArrays& particles) {
  turns_.solve(dtv);
  for (int k = 0; k < turns_.size(); ++k) {
    store(turns_.orientation(k), particles.quaternion[turning_[k]]);
    store(turns_.omega(k), particles.omega[turning_[k]]);
  }
  turns_.clear();
}

/// The moment of inertia about z; stops if z is no principal axis.
double FixNVEEllipsoid::inertia_about_z(int i) const {
  const ellipsoid::PlanarInertia inertia =
      planar_inertia(quaternion(atom->quaternion[i]), vector(atom->inertia[i]));
  if (inertia.misaligned > largest_misalignment)
    error->one(FLERR, ("Fix nve/ellipsoid (id " + std::string(id) + "): planar yes, but atom " +
                       std::to_string(atom->tag[i]) +
                       " has no principal axis along z; insert it with orientation planar, or set "
                       "its quaternion")
                          .c_str());
  return inertia.about_z;
}

std::size_t FixNVEEllipsoid::inverse_inertia_size() const {
  return static_cast<std::size_t>(atom->nlocal) * (planar_ ? 1 : 3);
}

void FixNVEEllipsoid::know_inertia() {
  inverse_inertia_.resize(inverse_inertia_size());
  for_each_atom([this](int i) {
    if (planar_)
      inverse_inertia_[static_cast<std::size_t>(i)] = 1.0 / inertia_about_z(i);
    else
      store(inverse(vector(atom->inertia[i])),
            inverse_inertia_.data() + 3 * static_cast<std::size_t>(i));
  });
}

ellipsoid::PlanarRows FixNVEEllipsoid::planar_rows() const {
  const ParticleArrays p(*atom);
  return {p.x[0],          p.v[0],      p.f[0],
          p.omega[0],      p.angmom[0], p.torque[0],
          p.quaternion[0], p.mass,      inverse_inertia_.data(),
          p.mask,          groupbit};
}

/// Derivatives of a particle that has none: of constant force, and of a torque that is constant in
/// the body frame.
void FixNVEEllipsoid::start(int i) const {
  if (planar_)
    keep_in_plane(ParticleArrays(*atom), i);
  double *linear = translation_->array_atom[i], *angular = rotation_->array_atom[i];
  std::fill(linear, linear + translation_values, 0.0);
  std::fill(angular, angular + rotation_values, 0.0);
  linear[0] = 1.0;
  for (int k = 0; k < 3; ++k)
    linear[1 + derivative_count * k] = atom->f[i][k] * force->ftm2v / atom->rmass[i];
  if (planar_) {
    angular[0] = atom->torque[i][2] * force->ftm2v / inertia_about_z(i);
    return;
  }
  const auto q = quaternion(atom->quaternion[i]);
  const ellipsoid::Vector3 inertia = vector(atom->inertia[i]);
  const auto derivatives =
      rotation_derivatives(q, angular_velocity(vector(atom->angmom[i]), inertia, q),
                           force->ftm2v * vector(atom->torque[i]), inertia);
  for (const ellipsoid::GearDerivatives& of_component : derivatives)
    angular = std::copy(of_component.begin(), of_component.end(), angular);
}

/// `step` changes the angle (0 before, rad) and the rate, given the moment of inertia about z.
template <class Step> void FixNVEEllipsoid::step_in_plane(int i, Step step) const {
  const double moment = inertia_about_z(i);
  double angle = 0.0, rate = atom->angmom[i][2] / moment;
  step(angle, rate, moment);
  store(turned_about_z(quaternion(atom->quaternion[i]), angle), atom->quaternion[i]);
  atom->omega[i][2] = rate;
  atom->angmom[i][2] = moment * rate;
}

void FixNVEEllipsoid::predict(int i, const ellipsoid::Gear& gear) const {
  if (translation_->array_atom[i][0] == 0.0)
    start(i);
  double *linear = translation_->array_atom[i] + 1, *angular = rotation_->array_atom[i];
  for (int k = 0; k < 3; ++k)
    gear.predict(atom->x[i][k], atom->v[i][k], linear + derivative_count * k);
  double* q = atom->quaternion[i];
  const ellipsoid::Vector3 inertia = vector(atom->inertia[i]);
  if (planar_) {
    step_in_plane(i,
                  [&](double& angle, double& rate, double) { gear.predict(angle, rate, angular); });
    return;
  }
  double rate[4];
  store(quaternion_rate(quaternion(q),
                        angular_velocity(vector(atom->angmom[i]), inertia, quaternion(q))),
        rate);
  for (int k = 0; k < 4; ++k)
    gear.predict(q[k], rate[k], angular + derivative_count * k);
  store(normalized(quaternion(q)), q);
  store_spin(i, angular_velocity_of_rate(quaternion(q), quaternion(rate)));
}

void FixNVEEllipsoid::correct(int i, const ellipsoid::Gear& gear) const {
  if (translation_->array_atom[i][0] == 0.0) {
    start(i); // came in this very step
    return;
  }
  if (planar_)
    keep_in_plane(ParticleArrays(*atom), i);
  double* linear = translation_->array_atom[i] + 1;
  for (int k = 0; k < 3; ++k)
    gear.correct(atom->x[i][k], atom->v[i][k], linear + derivative_count * k,
                 atom->f[i][k] * force->ftm2v / atom->rmass[i]);
  correct_rotation(i, gear);
}

void FixNVEEllipsoid::correct_rotation(int i, const ellipsoid::Gear& gear) const {
  double *angular = rotation_->array_atom[i], *q = atom->quaternion[i];
  if (planar_) {
    step_in_plane(i, [&](double& angle, double& rate, double moment) {
      gear.correct(angle, rate, angular, atom->torque[i][2] * force->ftm2v / moment);
    });
    return;
  }
  const auto predicted = quaternion(q);
  const ellipsoid::Vector3 omega = vector(atom->omega[i]), inertia = vector(atom->inertia[i]);
  double rate[4], second[4];
  store(quaternion_rate(predicted, omega), rate);
  store(
      quaternion_acceleration(
          predicted, omega,
          angular_acceleration(predicted, omega, force->ftm2v * vector(atom->torque[i]), inertia)),
      second);
  for (int k = 0; k < 4; ++k)
    gear.correct(q[k], rate[k], angular + derivative_count * k, second[k]);
  store(normalized(quaternion(q)), q);
  store_spin(i, angular_velocity_of_rate(quaternion(q), quaternion(rate)));
}

void FixNVEEllipsoid::store_spin(int i, const ellipsoid::Vector3& omega) const {
  store(omega, atom->omega[i]);
  store(angular_momentum(omega, vector(atom->inertia[i]), quaternion(atom->quaternion[i])),
        atom->angmom[i]);
}

/// Everything that is done per particle is inlined. Particles turn together with others: as soon as
/// the batch is full.
__attribute__((flatten)) void FixNVEEllipsoid::start_step_in_space() {
  const double *inverse_inertia = inverse_inertia_.data(), step = dtv, half_step = dtf;
  const ParticleArrays p(*atom);
  for_each_atom([=](int i) {
    kick(p, i, half_step);
    for (int k = 0; k < 3; ++k)
      p.x[i][k] += step * p.v[i][k];
    turning_[turns_.size()] = i;
    turns_.add(quaternion(p.quaternion[i]), vector(p.angmom[i]),
               vector(inverse_inertia + 3 * static_cast<std::ptrdiff_t>(i)));
    if (turns_.full())
      turn_waiting(p);
  });
  turn_waiting(p);
}

/// Everything that is done per particle is inlined.
__attribute__((flatten)) void FixNVEEllipsoid::end_step_in_space() {
  const double *inverse_inertia = inverse_inertia_.data(), half_step = dtf;
  for_each_atom([=, p = ParticleArrays(*atom)](int i) {
    kick(p, i, half_step);
    store(angular_velocity_by_inverse(vector(p.angmom[i]),
                                      vector(inverse_inertia + 3 * static_cast<std::ptrdiff_t>(i)),
                                      quaternion(p.quaternion[i])),
          p.omega[i]);
  });
}

/// The host's command `timestep` tells no fix, and `run ... pre no` does not call init().
void FixNVEEllipsoid::initial_integrate(int) {
  reset_dt();
  if (!gear_ && inverse_inertia_.size() != inverse_inertia_size())
    know_inertia();
  if (gear_)
    for_each_atom([this, gear = ellipsoid::Gear(dtv)](int i) { predict(i, gear); });
  else if (planar_)
    start_planar_step(planar_rows(), candidate_count(), dtv, dtf);
  else
    start_step_in_space();
}

void FixNVEEllipsoid::final_integrate() {
  if (!gear_ && neighbor->ago == 0)
    know_inertia();
  if (gear_)
    for_each_atom([this, gear = ellipsoid::Gear(dtv)](int i) { correct(i, gear); });
  else if (planar_)
    end_planar_step(planar_rows(), candidate_count(), dtf);
  else
    end_step_in_space();
}

void FixNVEEllipsoid::initial_integrate_respa(int, int, int) {
  error->fix_error(FLERR, this, "does not work with run_style respa; use run_style verlet");
}

void FixNVEEllipsoid::final_integrate_respa(int, int) {
  error->fix_error(FLERR, this, "does not work with run_style respa; use run_style verlet");
}
