// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "surface_sampling.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

std::size_t count_for(double area, double spacing) {
  constexpr std::size_t fewest = 12;
  return std::max(fewest, static_cast<std::size_t>(std::ceil(area / (spacing * spacing))));
}

void append_ellipsoid(std::vector<Vector3>& points, const Particle& p, double depth,
                      double spacing) {
  const Vector3& s = p.semiaxes;
  const Rotation3 r = rotation(p.orientation);
  // directions are mapped by the semi-axes; the area of a patch grows by two of them at the most
  const double area = 4.0 * pi * std::max({s.x * s.y, s.y * s.z, s.z * s.x});
  for (const Vector3& u : directions_on_sphere(count_for(area, spacing))) {
    const Vector3 normal = normalized(Vector3{u.x / s.x, u.y / s.y, u.z / s.z});
    points.push_back(p.centre +
                     r.to_space(Vector3{s.x * u.x, s.y * u.y, s.z * u.z} - depth * normal));
  }
}

} // namespace

std::vector<Vector3> directions_on_sphere(std::size_t count) {
  const double golden = pi * (3.0 - std::sqrt(5.0)), n = static_cast<double>(count);
  std::vector<Vector3> directions;
  directions.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double z = 1.0 - (2.0 * static_cast<double>(k) + 1.0) / n;
    const double across = std::sqrt(1.0 - z * z), turn = golden * static_cast<double>(k);
    directions.push_back({across * std::cos(turn), across * std::sin(turn), z});
  }
  return directions;
}

double smallest_curvature_radius(const ParticleSet& set, const Particle& particle) {
  const double smallest = particle.smallest_axis();
  if (particle.is_smooth())
    return smallest * smallest / particle.largest_axis();
  double radius = set.spheres[particle.first_sphere].radius;
  for (std::size_t k = 0; k < particle.sphere_count; ++k)
    radius = std::min(radius, set.spheres[particle.first_sphere + k].radius);
  return radius;
}

std::vector<Vector3> surface_points_of(const ParticleSet& set, const Particle& particle,
                                       double depth, double spacing) {
  std::vector<Vector3> points;
  if (particle.is_smooth()) {
    append_ellipsoid(points, particle, depth, spacing);
    return points;
  }
  const Sphere* const begin = set.spheres.data() + particle.first_sphere;
  const Sphere* const end = begin + particle.sphere_count;
  for (const Sphere* s = begin; s != end; ++s) {
    const double radius = s->radius - depth;
    for (const Vector3& u : directions_on_sphere(count_for(4.0 * pi * radius * radius, spacing))) {
      const Vector3 point = s->centre + radius * u;
      const bool is_hidden = std::any_of(begin, end, [&](const Sphere& t) {
        return &t != s && norm(point - t.centre) < t.radius - depth;
      });
      if (!is_hidden)
        points.push_back(point);
    }
  }
  return points;
}

} // namespace ellipsoid::post
