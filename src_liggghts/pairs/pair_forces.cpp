// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pair_forces.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "force.h"
#include "model_settings.h"
#include "pair_gran_ellipsoid.h"
#include "update.h"

#include <cmath>

namespace ellipsoid_host {

using namespace LAMMPS_NS;
using namespace LIGGGHTS::ContactModels;

void PairForces::read_settings(const ModelSettings& settings) {
  laws_.choose([this](const std::string& kind,
                      const std::string& name) { return models_.contact_match(kind, name); },
               settings, [this](const std::string& value) { return pair_.history_offset(value); });
}

void PairForces::connect(PropertyRegistry& registry) {
  laws_.connect(registry, force->nktv2p == 1.0);
}

void PairForces::begin_step(bool for_list) {
  particles_ = ParticleArrays(*atom);
  newton_ = force->newton_pair;
  computes_forces_ = pair_.computeflag();
  is_time_step_ = pair_.computeflag() && pair_.shearupdate();
  frozen_group_ = pair_.freeze_group_bit();
  rigid_masses_ = pair_.fr_pair() ? pair_.mr_pair() : nullptr;
  if (laws_.run_in_batches())
    laws_.begin_step(batch_);
  reports_.begin_step(for_list);
  SurfacesIntersectData data = common_data();
  models_.begin_pass(data);
}

void PairForces::end_step() {
  SurfacesIntersectData data = common_data();
  models_.end_pass(data);
  reports_.end_step();
}

SurfacesIntersectData PairForces::common_data() const {
  SurfacesIntersectData data;
  data.is_non_spherical = true;
  data.computeflag = pair_.computeflag();
  data.shearupdate = pair_.shearupdate();
  return data;
}

double PairForces::mass(int i) const {
  return rigid_masses_ && rigid_masses_[i] > 0.0 ? rigid_masses_[i] : particles_.mass[i];
}

inline ellipsoid::PairMasses PairForces::masses(int i, int j) const {
  if (!frozen_group_ && !rigid_masses_)
    return {particles_.mass[i], particles_.mass[j]};
  if (particles_.mask[i] & frozen_group_)
    return ellipsoid::PairMasses::one_held(mass(j));
  if (particles_.mask[j] & frozen_group_)
    return ellipsoid::PairMasses::one_held(mass(i));
  return {mass(i), mass(j)};
}

void PairForces::close(int i, int j, int* flag, double* history) {
  SurfacesIntersectData data = common_data();
  data.i = i;
  data.j = j;
  data.contact_flags = flag;
  data.contact_history = history;
  models_.close(data);
}

void PairForces::apply_found(const ellipsoid::ContactBatch& search, const Contact* contacts,
                             bool are_flagged) {
  apply_added();
  batch_.set_frames(search);
  apply(contacts, are_flagged);
  batch_.clear();
}

void PairForces::apply(const Contact* contacts, bool are_flagged) {
  if (laws_.run_in_batches())
    apply_in_batch(contacts, are_flagged);
  else
    apply_by_models(contacts);
}

/// Forces are added up in the order of the contacts.
void PairForces::apply_in_batch(const Contact* contacts, bool are_flagged) {
  gather(contacts, are_flagged);
  laws_.solve(batch_, update->dt, is_time_step_, false);
  const bool in_plane = batch_.are_in_plane(), computes = computes_forces_;
  const bool reports = reports_.are_wanted() || pair_.keeps_records();
  for (int k = 0; k < batch_.size(); ++k) {
    const Contact& contact = contacts[k];
    if (!contact.history)
      continue;
    if (is_time_step_)
      laws_.remember(batch_, k, contact.history);
    if (computes && in_plane)
      add_action<true>(contact, k);
    else if (computes)
      add_action<false>(contact, k);
    if (reports)
      report_action(contact, k);
  }
}

/// Motion, masses, material and memory of the contacts.
void PairForces::gather(const Contact* contacts, bool are_flagged) {
  for (int k = 0; k < batch_.size(); ++k) {
    const int i = contacts[k].i, j = contacts[k].j;
    const double* history = contacts[k].history;
    if (!history)
      continue;
    if (!are_flagged)
      *contacts[k].flag |= laws_.flags();
    batch_.set_motion(k,
                      {vector(particles_.v[i]) - vector(particles_.v[j]),
                       vector(particles_.omega[i]), vector(particles_.omega[j])},
                      masses(i, j));
    laws_.set(batch_, k, particles_.type[i], particles_.type[j], history);
  }
}

/// @tparam in_plane forces lie in the xy plane, torques along z: the other components are 0
template <bool in_plane> inline void PairForces::add_action(const Contact& contact, int k) {
  const ellipsoid::ContactAction action = batch_.action(k);
  const auto add = [this](int i, const ellipsoid::Vector3& f, const ellipsoid::Vector3& t) {
    double *to = particles_.f[i], *torque = particles_.torque[i];
    to[0] += f.x;
    to[1] += f.y;
    torque[2] += t.z;
    if (in_plane)
      return;
    to[2] += f.z;
    torque[0] += t.x;
    torque[1] += t.y;
  };
  const double share_i = contact.weight * pair_.relax(contact.i);
  add(contact.i, share_i * action.force, share_i * action.torque_i);
  if (!owns(contact.j))
    return;
  const double share_j = contact.weight * pair_.relax(contact.j);
  add(contact.j, -share_j * action.force, share_j * action.torque_j);
}

__attribute__((noinline)) void PairForces::report_action(const Contact& contact, int k) {
  const ellipsoid::ContactAction action = batch_.action(k);
  const SurfacesIntersectData c = record(contact, k);
  ForceData force_i, force_j;
  store(contact.weight * action.force, force_i.delta_F);
  store(-contact.weight * action.force, force_j.delta_F);
  store(contact.weight * action.torque_i, force_i.delta_torque);
  store(contact.weight * action.torque_j, force_j.delta_torque);
  if (computes_forces_ && pair_.keeps_records()) {
    pair_.set_spheres(contact.sphere_i, contact.sphere_j, contact.weight);
    pair_.add_record(c, action.force, *atom, nullptr);
  }
  if (reports_.are_wanted())
    reports_.add(c, force_i, force_j, owns(c.j));
}

void PairForces::apply_by_models(const Contact* contacts) {
  const auto weigh = [](ForceData& f, double weight) {
    for (int k = 0; k < 3; ++k) {
      f.delta_F[k] *= weight;
      f.delta_torque[k] *= weight;
    }
  };
  for (int k = 0; k < batch_.size(); ++k) {
    const Contact& contact = contacts[k];
    if (!contact.history)
      continue;
    SurfacesIntersectData c = record(contact, k);
    pair_.curvature_radius_i = c.radi;
    pair_.curvature_radius_j = c.radj;
    pair_.set_spheres(contact.sphere_i, contact.sphere_j, contact.weight);
    ForceData force_i, force_j;
    models_.apply(c, force_i, force_j);
    if (contact.weight != 1.0) {
      weigh(force_i, contact.weight);
      weigh(force_j, contact.weight);
    }
    const bool owns_j = owns(c.j);
    if (computes_forces_) {
      add_force(c.i, force_i);
      if (owns_j)
        add_force(c.j, force_j);
    }
    if (reports_.are_wanted())
      reports_.add(c, force_i, force_j, owns_j);
  }
}

void PairForces::add_force(int i, const ForceData& force) {
  const double relax = pair_.relax(i);
  for (int k = 0; k < 3; ++k) {
    atom->f[i][k] += relax * force.delta_F[k];
    atom->torque[i][k] += relax * force.delta_torque[k];
  }
}

ellipsoid::Vector3 PairForces::centre_distance(int i, int j) const {
  return vector(particles_.x[j]) - vector(particles_.x[i]);
}

/// Contact k of the batch as the host's contact models want it.
SurfacesIntersectData PairForces::record(const Contact& contact, int k) const {
  const int i = contact.i, j = contact.j;
  const ellipsoid::ContactFrame frame = batch_.frame(k);
  SurfacesIntersectData c = common_data();
  c.i = i;
  c.j = j;
  c.itype = atom->type[i];
  c.jtype = atom->type[j];
  const ellipsoid::Vector3 distance = centre_distance(i, j);
  store(-distance, c.delta);
  c.rsq = dot(distance, distance);
  c.r = std::sqrt(c.rsq);
  c.rinv = 1.0 / c.r;
  c.v_i = atom->v[i];
  c.v_j = atom->v[j];
  c.omega_i = atom->omega[i];
  c.omega_j = atom->omega[j];
  c.contact_flags = contact.flag;
  c.contact_history = contact.history;
  c.mi = mass(i);
  c.mj = mass(j);
  c.meff = masses(i, j).effective();
  store(frame.normal, c.en);
  store(vector(atom->x[i]) + frame.lever_i, c.contact_point);
  c.deltan = frame.overlap;
  c.reff = frame.reduced_radius;
  // local spheres with the Gaussian radii of curvature, scaled so that R_i R_j / (R_i + R_j) is the
  // R of Markauskas et al. 2010, eq. (19)
  const double scale =
      frame.reduced_radius * (frame.radius_i + frame.radius_j) / (frame.radius_i * frame.radius_j);
  c.radi = scale * frame.radius_i;
  c.radj = scale * frame.radius_j;
  c.radsum = c.radi + c.radj;
  return c;
}

} // namespace ellipsoid_host
