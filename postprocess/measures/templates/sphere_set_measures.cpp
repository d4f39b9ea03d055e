// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "sphere_set_measures.h"

#include "disc_union.h"
#include "ellipsoid/ellipsoid_properties.h"
#include "farthest_points.h"
#include "multisphere/multisphere_template.h"
#include "wall/surface_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;
constexpr int surface_points = 12000;

/// Distances of points, with means weighted with their areas (length).
struct DistanceSummary {
  std::vector<double> all;
  double mean = 0.0, rms = 0.0;
  double spacing = 0.0; ///< of neighbouring points
};

DistanceSummary add_up(const std::vector<SurfacePoint>& points,
                       const std::function<double(const Vector3&)>& distance) {
  DistanceSummary found;
  double area = 0.0, sum = 0.0, squares = 0.0;
  for (const SurfacePoint& point : points) {
    const double d = distance(point.position);
    found.all.push_back(d);
    sum += point.area * d;
    squares += point.area * d * d;
    area += point.area;
  }
  if (area > 0.0) {
    found.mean = sum / area;
    found.rms = std::sqrt(squares / area);
    found.spacing = std::sqrt(area / static_cast<double>(points.size()));
  }
  return found;
}

std::vector<Vector3> positions_of(const std::vector<SurfacePoint>& points) {
  std::vector<Vector3> positions;
  for (const SurfacePoint& point : points)
    positions.push_back(point.position);
  return positions;
}

/// The spheres that come this near to a point.
SphereSet near_spheres(const SphereSet& set, const Vector3& point, double distance) {
  SphereSet near;
  for (std::size_t k = 0; k < set.radii.size(); ++k)
    if (norm(point - set.centres[k]) - set.radii[k] < distance) {
      near.centres.push_back(set.centres[k]);
      near.radii.push_back(set.radii[k]);
    }
  return near;
}

/// From points of the solid's surface to the spheres.
double largest_to_spheres(const SphereSet& set, const Solid& solid,
                          const DistanceSummary& samples) {
  const std::vector<Vector3> points = positions_of(solid.points);
  std::vector<Climb> climbs;
  for (const std::size_t k : largest_samples(points, samples.all, samples.spacing)) {
    // whatever decides the distance of a point that the climb can reach
    const auto near = std::make_shared<const SphereSet>(
        near_spheres(set, points[k], samples.all[k] + 2.0 * reach_of_climb * samples.spacing));
    climbs.push_back({points[k], samples.all[k], solid.onto,
                      [near](const Vector3& p) { return UnionDistance(*near).from(p); }});
  }
  return highest(std::move(climbs), samples.spacing);
}

/// The sphere on whose surface a point lies.
std::size_t sphere_of(const SphereSet& set, const Vector3& point) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < set.radii.size(); ++k)
    if (const double d = std::fabs(norm(point - set.centres[k]) - set.radii[k]); d < least) {
      least = d;
      nearest = k;
    }
  return nearest;
}

/// From points of the spheres' uncovered parts to the solid's surface.
double largest_to_solid(const SphereSet& set, const Solid& solid,
                        const std::vector<SurfacePoint>& surface, const DistanceSummary& samples) {
  const std::vector<Vector3> points = positions_of(surface);
  std::vector<Climb> climbs;
  for (const std::size_t k : largest_samples(points, samples.all, samples.spacing)) {
    const std::size_t own = sphere_of(set, points[k]);
    const Vector3 centre = set.centres[own];
    const double radius = set.radii[own];
    const auto near = std::make_shared<const SphereSet>(
        near_spheres(set, points[k], reach_of_climb * samples.spacing));
    climbs.push_back(
        {points[k], samples.all[k],
         [centre, radius](const Vector3& p) { return centre + radius * normalized(p - centre); },
         [near, distance = solid.distance](const Vector3& p) {
           return is_on_surface(*near, p) ? distance(p) : -1.0;
         }});
  }
  return highest(std::move(climbs), samples.spacing);
}

double distance_from_ellipsoid(const Vector3& s, const Vector3& point) {
  const Vector3 n = nearest_normal(s, point);
  const Vector3 stretched{s.x * s.x * n.x, s.y * s.y * n.y, s.z * s.z * n.z};
  return norm(point - (1.0 / std::sqrt(dot(n, stretched))) * stretched);
}

} // namespace

Solid solid_ellipsoid(const Vector3& s) {
  Solid solid;
  solid.volume = volume(s);
  solid.surface = surface_area(s);
  const Vector3 moments = principal_moments(s, solid.volume);
  solid.inertia = {moments.x, moments.y, moments.z, 0.0, 0.0, 0.0};
  solid.box = {-s, s};
  for (const Vector3& w : unit_sphere_points(surface_points)) {
    const Vector3 slope{w.x / s.x, w.y / s.y, w.z / s.z};
    solid.points.push_back({{s.x * w.x, s.y * w.y, s.z * w.z},
                            4.0 * pi / surface_points * s.x * s.y * s.z * norm(slope)});
  }
  solid.columns = [s](const ColumnGrid& grid) { return ellipsoid_columns(grid, s); };
  solid.distance = [s](const Vector3& point) { return distance_from_ellipsoid(s, point); };
  solid.onto = [s](const Vector3& p) {
    return (1.0 / norm(Vector3{p.x / s.x, p.y / s.y, p.z / s.z})) * p;
  };
  return solid;
}

double share_in_exactly_one(const SphereSet& set, const Solid& solid, int along) {
  auto [lower, upper] = solid.box;
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    const Vector3& c = set.centres[k];
    const double r = set.radii[k];
    lower = {std::min(lower.x, c.x - r), std::min(lower.y, c.y - r), std::min(lower.z, c.z - r)};
    upper = {std::max(upper.x, c.x + r), std::max(upper.y, c.y + r), std::max(upper.z, c.z + r)};
  }
  const ColumnGrid grid = columns_over(solid.box, {lower, upper}, along);
  const CommonVolume volumes = common_volume(grid, solid.columns(grid), sphere_columns(grid, set));
  return volumes.in_exactly_one() / solid.volume;
}

OutlineDistances outline_distances(const SphereSet& set, const Solid& solid) {
  const UnionDistance from_spheres(set);
  const DistanceSummary to_spheres =
      add_up(solid.points, [&](const Vector3& p) { return from_spheres.from(p); });
  const std::vector<SurfacePoint> surface = union_surface_points(set, 4 * surface_points);
  const DistanceSummary to_solid = add_up(surface, solid.distance);
  OutlineDistances found;
  found.largest_to_spheres = largest_to_spheres(set, solid, to_spheres);
  found.mean_to_spheres = to_spheres.mean;
  found.rms_to_spheres = to_spheres.rms;
  found.largest_to_solid = largest_to_solid(set, solid, surface, to_solid);
  found.mean_to_solid = to_solid.mean;
  found.rms_to_solid = to_solid.rms;
  return found;
}

SectionFactors section_factors(const SphereSet& set, const Vector3& semiaxes) {
  const double axes[3] = {semiaxes.x, semiaxes.y, semiaxes.z};
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t k, std::size_t l) { return axes[k] > axes[l]; });
  std::vector<Disc> discs;
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    const double c[3] = {set.centres[k].x, set.centres[k].y, set.centres[k].z};
    const double height = c[order[2]], square = set.radii[k] * set.radii[k] - height * height;
    if (square > 0.0)
      discs.push_back({c[order[0]], c[order[1]], std::sqrt(square)});
  }
  const DiscUnion section = measure_discs(discs);
  const double a = axes[order[0]], b = axes[order[1]];
  return {std::fabs(section.area / ellipse_area(a, b) - 1.0),
          std::fabs(section.perimeter / ellipse_perimeter(a, b) - 1.0)};
}

} // namespace ellipsoid::post
