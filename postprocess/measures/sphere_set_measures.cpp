// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "sphere_set_measures.h"

#include "ellipsoid/ellipsoid_properties.h"
#include "wall/surface_points.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;
constexpr int surface_points = 12000;

/// Weighted mean and largest of distances.
void add_up(const std::vector<SurfacePoint>& points,
            const std::function<double(const Vector3&)>& distance, double& largest, double& mean) {
  double area = 0.0, sum = 0.0;
  for (const SurfacePoint& point : points) {
    const double found = distance(point.place);
    largest = std::max(largest, found);
    sum += point.area * found;
    area += point.area;
  }
  mean = area > 0.0 ? sum / area : 0.0;
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
  OutlineDistances found;
  add_up(
      solid.points, [&](const Vector3& p) { return from_spheres.from(p); },
      found.largest_to_spheres, found.mean_to_spheres);
  add_up(union_surface_points(set, 4 * surface_points), solid.distance, found.largest_to_solid,
         found.mean_to_solid);
  return found;
}

} // namespace ellipsoid::post
