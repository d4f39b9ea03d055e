// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "body_properties.h"

#include "ellipsoid/ellipsoid_properties.h"
#include "multisphere/union_measures.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

struct LineSphere {
  double abscissa, radius;
};

/// The spheres of a body along the line of their centres; empty where there is no such line.
std::vector<LineSphere> on_one_line(const ParticleSet& set, const Particle& p) {
  constexpr double off_the_line = 1.0e-6; // of a radius: rounding of positions in files
  const Sphere* const begin = set.spheres.data() + p.first_sphere;
  const Sphere* const end = begin + p.sphere_count;
  const Sphere* const farthest =
      std::max_element(begin, end, [&](const Sphere& s, const Sphere& t) {
        return norm(s.centre - begin->centre) < norm(t.centre - begin->centre);
      });
  const Vector3 way = farthest->centre - begin->centre;
  const Vector3 axis = norm(way) > 0.0 ? normalized(way) : Vector3{1.0, 0.0, 0.0};
  std::vector<LineSphere> line;
  for (const Sphere* s = begin; s != end; ++s) {
    const Vector3 d = s->centre - begin->centre;
    const double along = dot(d, axis);
    if (norm(d - along * axis) > off_the_line * s->radius)
      return {};
    line.push_back({along, s->radius});
  }
  std::sort(line.begin(), line.end(),
            [](const LineSphere& s, const LineSphere& t) { return s.abscissa < t.abscissa; });
  return line;
}

double volume_on_line(const std::vector<LineSphere>& line) {
  MultisphereTemplate chain;
  for (const LineSphere& s : line) {
    chain.centres.push_back(s.abscissa);
    chain.radii.push_back(s.radius);
  }
  double volume = 0.0;
  for (const CutOffSphere& part : cut_off_spheres(chain)) {
    const double r = chain.radii[static_cast<std::size_t>(part.sphere)];
    const auto below = [r](double u) { return u * (r * r - u * u / 3.0); };
    volume += pi * (below(part.to) - below(part.from));
  }
  return volume;
}

} // namespace

double body_volume(const ParticleSet& set, const Particle& particle) {
  if (particle.is_smooth())
    return volume(particle.semiaxes);
  if (const auto line = on_one_line(set, particle); !line.empty())
    return volume_on_line(line);
  SphereSet spheres;
  for (std::size_t k = 0; k < particle.sphere_count; ++k) {
    const Sphere& sphere = set.spheres[particle.first_sphere + k];
    spheres.centres.push_back(sphere.centre - particle.centre);
    spheres.radii.push_back(sphere.radius);
  }
  return measure_union(spheres).volume;
}

double volume_radius(double volume) { return std::cbrt(0.75 * volume / pi); }

SymmetricMatrix3 body_inertia(const Particle& particle, double mass) {
  const bool is_clump = norm(particle.moments_per_mass) > 0.0;
  const Vector3 moments =
      is_clump ? mass * particle.moments_per_mass : principal_moments(particle.semiaxes, mass);
  return rotated_diagonal(rotation(particle.orientation), moments.x, moments.y, moments.z);
}

} // namespace ellipsoid::post
