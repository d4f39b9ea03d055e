// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "union_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

/// A point this close to a sphere, as a share of its radius, is not in it.
constexpr double rounding = 1e-10;

} // namespace

std::vector<Vector3> unit_sphere_points(int count) {
  std::vector<Vector3> points;
  const double golden_angle = pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z);
    points.push_back({r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z});
  }
  return points;
}

std::vector<SurfacePoint> union_surface_points(const SphereSet& set, int count) {
  double squares = 0.0;
  for (const double r : set.radii)
    squares += r * r;
  std::vector<SurfacePoint> points;
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    const double r = set.radii[k];
    std::vector<std::size_t> near;
    for (std::size_t l = 0; l < set.radii.size(); ++l)
      if (l != k && norm(set.centres[l] - set.centres[k]) < r + set.radii[l])
        near.push_back(l);
    const int own = std::max(32, static_cast<int>(count * r * r / squares));
    for (const Vector3& n : unit_sphere_points(own)) {
      const Vector3 p = set.centres[k] + r * n;
      if (std::none_of(near.begin(), near.end(), [&](std::size_t l) {
            return norm(p - set.centres[l]) < set.radii[l] * (1.0 - rounding);
          }))
        points.push_back({p, 4.0 * pi * r * r / own});
    }
  }
  return points;
}

bool UnionDistance::is_uncovered(const Vector3& point, std::size_t k, std::size_t l) const {
  for (std::size_t m = 0; m < set_.radii.size(); ++m)
    if (m != k && m != l && norm(point - set_.centres[m]) < set_.radii[m] * (1.0 - rounding))
      return false;
  return true;
}

double UnionDistance::from(const Vector3& point) const {
  double outside = std::numeric_limits<double>::infinity(), nearest = outside, depth = 0.0;
  for (std::size_t k = 0; k < set_.radii.size(); ++k) {
    const Vector3 apart = point - set_.centres[k];
    const double distance = norm(apart), r = set_.radii[k];
    outside = std::min(outside, distance - r);
    if (distance >= r || distance == 0.0)
      continue;
    depth = std::max(depth, r - distance);
    if (r - distance < nearest && is_uncovered(set_.centres[k] + (r / distance) * apart, k, k))
      nearest = r - distance;
  }
  if (outside >= 0.0)
    return outside;
  // nothing of the surface is nearer than the depth in the sphere that reaches farthest
  return nearest <= depth * (1.0 + rounding) ? nearest : from_seams(point, nearest);
}

/// The circles in which two spheres cut each other.
double UnionDistance::from_seams(const Vector3& point, double reached) const {
  std::vector<std::size_t> near;
  for (std::size_t k = 0; k < set_.radii.size(); ++k)
    if (std::fabs(norm(point - set_.centres[k]) - set_.radii[k]) < reached)
      near.push_back(k);
  for (std::size_t i = 0; i < near.size(); ++i)
    for (std::size_t j = i + 1; j < near.size(); ++j) {
      const std::size_t k = near[i], l = near[j];
      const Vector3 apart = set_.centres[l] - set_.centres[k];
      const double distance = norm(apart), r = set_.radii[k], s = set_.radii[l];
      const double height = 0.5 * (distance + (r - s) * (r + s) / distance);
      if (!(std::fabs(height) < r))
        continue;
      const Vector3 axis = (1.0 / distance) * apart;
      const Vector3 middle = set_.centres[k] + height * axis;
      const Vector3 across = point - middle - part_along(point - middle, axis);
      if (norm(across) == 0.0)
        continue;
      const Vector3 q = middle + std::sqrt((r - height) * (r + height)) * normalized(across);
      if (norm(q - point) < reached && is_uncovered(q, k, l))
        reached = norm(q - point);
    }
  return reached;
}

} // namespace ellipsoid::post
