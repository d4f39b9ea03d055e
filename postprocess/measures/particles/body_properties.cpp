// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "body_properties.h"

#include "ellipsoid/ellipsoid_properties.h"
#include "multisphere/union_measures.h"

#include <cmath>

namespace ellipsoid::post {
namespace {

/// The exact measures of the union of a body's spheres.
ellipsoid::UnionMeasures union_of(const ParticleSet& set, const Particle& p) {
  SphereSet spheres;
  for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k) {
    spheres.centres.push_back(set.spheres[k].centre);
    spheres.radii.push_back(set.spheres[k].radius);
  }
  return measure_union(spheres);
}

/// Whether the centres of a body's spheres lie on its long axis.
bool is_chain(const ParticleSet& set, const Particle& p) {
  constexpr double off_the_line = 1.0e-5; // of a radius: six digits in the file
  const Vector3 axis = rotation(p.orientation).column_x;
  for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k) {
    const Vector3 d = set.spheres[k].centre - p.centre;
    if (norm(d - dot(d, axis) * axis) > off_the_line * set.spheres[k].radius)
      return false;
  }
  return true;
}

} // namespace

double body_volume(const ParticleSet& set, const Particle& particle) {
  return particle.is_smooth() ? volume(particle.semiaxes) : union_of(set, particle).volume;
}

double volume_radius(double volume) { return std::cbrt(0.75 * volume / M_PI); }

SymmetricMatrix3 body_inertia(const ParticleSet& set, const Particle& particle, double mass) {
  Vector3 moments = principal_moments(particle.semiaxes, mass);
  if (set.has_moments && particle.mass > 0.0) {
    moments = (mass / particle.mass) * particle.principal_moments;
  } else if (norm(particle.moments_per_mass) > 0.0) {
    moments = mass * particle.moments_per_mass;
  } else if (particle.is_host_body && !is_chain(set, particle)) {
    const ellipsoid::UnionMeasures body = union_of(set, particle);
    return (mass / body.volume) * body.inertia;
  }
  return rotated_diagonal(rotation(particle.orientation), moments.x, moments.y, moments.z);
}

} // namespace ellipsoid::post
