// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "rest.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {

RestCheck check_rest(const ParticleSet& set, const std::vector<std::size_t>& members,
                     double gravity) {
  constexpr double share_of_fall = 0.01;
  RestCheck result;
  result.is_known = static_cast<bool>(set.has_velocities);
  set.has_spins.require_readable();
  result.speed_limit = share_of_fall * std::sqrt(gravity * mean_smallest_axis(set, members));
  for (const std::size_t i : members) {
    const Particle& p = set.particles[i];
    const double spin = norm(p.angular_velocity), speed = norm(p.velocity);
    result.largest_spin = std::max(result.largest_spin, spin);
    result.largest_speed = std::max(result.largest_speed, speed + p.largest_axis() * spin);
  }
  result.is_at_rest = result.is_known && result.largest_speed < result.speed_limit;
  return result;
}

} // namespace ellipsoid::post
