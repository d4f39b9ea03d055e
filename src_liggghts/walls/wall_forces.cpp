// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall_forces.h"

#include "ellipsoid_host.h"
#include "law/cohesion_laws.h"

namespace ellipsoid_host {

/// The wall is body j: it does not turn, and no force moves it.
void WallForces::add(const ContactWithWall& contact) {
  const int i = contact.particle, k = batch_.size();
  const ellipsoid::WallContact& at = contact.geometry;
  contacts_[k] = contact;
  batch_.add({-at.normal,
              at.point,
              {},
              at.overlap,
              at.reduced_radius,
              at.reduced_radius,
              ellipsoid::plane_radius(at.reduced_radius)});
  batch_.set_motion(k,
                    {vector(particles_.v[i]) - contact.velocity, vector(particles_.omega[i]), {}},
                    ellipsoid::PairMasses::one_held(particles_.mass[i]));
  models_.set(batch_, k, particles_.type[i], contact.wall_type, contact.history);
}

void WallForces::solve(double time_step, bool is_time_step) {
  models_.solve(batch_, time_step, is_time_step, true);
  if (is_time_step)
    for (int k = 0; k < batch_.size(); ++k)
      models_.remember(batch_, k, contacts_[k].history);
}

} // namespace ellipsoid_host
