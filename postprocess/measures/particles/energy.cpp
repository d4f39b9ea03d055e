// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "energy.h"

#include "body_properties.h"

namespace ellipsoid::post {
namespace {

/// With the body's own inertia, or with given principal moments.
double rotation_energy(const ParticleSet& set, const Particle& p,
                       const std::optional<Vector3>& moments) {
  if (!moments)
    return 0.5 * dot(p.angular_velocity, body_inertia(set, p, p.mass) * p.angular_velocity);
  const Vector3 spin = rotation(p.orientation).to_body(p.angular_velocity);
  return 0.5 * (moments->x * spin.x * spin.x + moments->y * spin.y * spin.y +
                moments->z * spin.z * spin.z);
}

} // namespace

Energy energy(const ParticleSet& set, const EnergyOptions& options) {
  if (!set.has_velocities)
    throw InputError("energies need the columns vx vy vz (and omegax omegay omegaz)");
  if (options.inertia && !set.has_spins)
    throw InputError("--inertia is for rotation, but the file has no columns omegax omegay omegaz: "
                     "leave it out");
  if (set.asymmetric_bodies > 0)
    throw InputError(
        "the mass centres of bodies whose spheres are not symmetric about a point are not "
        "in the file: take the energies from the host (compute ke/multisphere)");
  set.has_masses.require_readable();
  Energy sum;
  if (set.has_spins)
    sum.rotation = 0.0;
  if (options.gravity)
    sum.potential = 0.0;
  for (const Particle& p : set.particles) {
    if (!(p.mass > 0.0))
      throw InputError("energies need a column \"mass\" with masses > 0");
    sum.translation += 0.5 * p.mass * dot(p.velocity, p.velocity);
    if (sum.rotation)
      *sum.rotation += rotation_energy(set, p, options.inertia);
    if (sum.potential)
      *sum.potential -= p.mass * dot(*options.gravity, p.centre);
  }
  return sum;
}

} // namespace ellipsoid::post
