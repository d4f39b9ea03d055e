// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "energy.h"

namespace ellipsoid::post {

Energy energy(const ParticleSet& set, const EnergyOptions& options) {
  Energy sum;
  if (!set.has_velocities)
    throw InputError("energies need the columns vx vy vz (and omegax omegay omegaz)");
  for (const Particle& p : set.particles) {
    if (!(p.mass > 0.0))
      throw InputError("energies need a column \"mass\" with masses > 0");
    const Vector3& s = p.semiaxes;
    const Vector3 solid = (p.mass / 5.0) * Vector3{s.y * s.y + s.z * s.z, s.x * s.x + s.z * s.z,
                                                   s.x * s.x + s.y * s.y};
    const Vector3 moments = options.inertia.value_or(solid);
    const Vector3 spin = rotation(p.orientation).to_body(p.angular_velocity);
    sum.translation += 0.5 * p.mass * dot(p.velocity, p.velocity);
    sum.rotation += 0.5 * (moments.x * spin.x * spin.x + moments.y * spin.y * spin.y +
                           moments.z * spin.z * spin.z);
    sum.potential -= p.mass * dot(options.gravity, p.centre);
  }
  return sum;
}

} // namespace ellipsoid::post
