// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "energy.h"

namespace ellipsoid::post {
namespace {

/// Of the solid ellipsoid, or clump (mass length^2).
Vector3 solid_moments(const Particle& p) {
  if (norm(p.moments_per_mass) > 0.0)
    return p.mass * p.moments_per_mass;
  const Vector3& s = p.semiaxes;
  return (p.mass / 5.0) *
         Vector3{s.y * s.y + s.z * s.z, s.x * s.x + s.z * s.z, s.x * s.x + s.y * s.y};
}

double rotation_energy(const Particle& p, const Vector3& moments) {
  const Vector3 spin = rotation(p.orientation).to_body(p.angular_velocity);
  return 0.5 *
         (moments.x * spin.x * spin.x + moments.y * spin.y * spin.y + moments.z * spin.z * spin.z);
}

} // namespace

Energy energy(const ParticleSet& set, const EnergyOptions& options) {
  if (!set.has_velocities)
    throw InputError("energies need the columns vx vy vz (and omegax omegay omegaz)");
  if (set.asymmetric_bodies > 0)
    throw InputError(
        "the mass centres of bodies whose spheres are not symmetric about a point are not "
        "in the file: take the energies from the host (compute ke/multisphere)");
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
      *sum.rotation += rotation_energy(p, options.inertia.value_or(solid_moments(p)));
    if (sum.potential)
      *sum.potential -= p.mass * dot(*options.gravity, p.centre);
  }
  return sum;
}

} // namespace ellipsoid::post
