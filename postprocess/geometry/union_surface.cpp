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

bool is_on_surface(const SphereSet& set, const Vector3& point) {
  for (std::size_t m = 0; m < set.radii.size(); ++m)
    if (norm(point - set.centres[m]) < set.radii[m] * (1.0 - rounding))
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
    if (r - distance < nearest && is_on_surface(set_, set_.centres[k] + (r / distance) * apart))
      nearest = r - distance;
  }
  if (outside >= 0.0)
    return outside;
  // nothing of the surface is nearer than the depth in the sphere that reaches farthest
  return nearest <= depth * (1.0 + rounding) ? nearest : from_seams(point, nearest);
}

namespace {

/// The circle in which two spheres cut each other; radius 0 if they do not.
struct Seam {
  Vector3 middle, axis;
  double radius = 0.0;
};

Seam seam_of(const SphereSet& set, std::size_t k, std::size_t l) {
  const Vector3 apart = set.centres[l] - set.centres[k];
  const double distance = norm(apart), r = set.radii[k], s = set.radii[l];
  const double height = 0.5 * (distance + (r - s) * (r + s) / distance);
  if (!(std::fabs(height) < r))
    return {};
  const Vector3 axis = (1.0 / distance) * apart;
  return {set.centres[k] + height * axis, axis, std::sqrt((r - height) * (r + height))};
}

} // namespace

/// The circles in which two spheres cut each other, and where a third one covers the nearest point
/// of such a circle, the corners on it.
double UnionDistance::from_seams(const Vector3& point, double reached) const {
  std::vector<std::size_t> near;
  for (std::size_t k = 0; k < set_.radii.size(); ++k)
    if (std::fabs(norm(point - set_.centres[k]) - set_.radii[k]) < reached)
      near.push_back(k);
  for (std::size_t i = 0; i < near.size(); ++i)
    for (std::size_t j = i + 1; j < near.size(); ++j) {
      const Seam seam = seam_of(set_, near[i], near[j]);
      const Vector3 across = point - seam.middle - part_along(point - seam.middle, seam.axis);
      if (!(seam.radius > 0.0) || norm(across) == 0.0)
        continue;
      const Vector3 q = seam.middle + seam.radius * normalized(across);
      if (norm(q - point) >= reached)
        continue;
      reached = is_on_surface(set_, q) ? norm(q - point)
                                       : from_corners(point, near[i], near[j], near, reached);
    }
  return reached;
}

double UnionDistance::from_corners(const Vector3& point, std::size_t k, std::size_t l,
                                   const std::vector<std::size_t>& near, double reached) const {
  const Seam seam = seam_of(set_, k, l);
  for (const std::size_t m : near) {
    if (m == k || m == l)
      continue;
    // points of the circle in the plane n . (x - middle) = height of the seam with the third sphere
    const Vector3 apart = set_.centres[m] - set_.centres[k];
    const double r = set_.radii[k], s = set_.radii[m];
    const double height =
        0.5 * (dot(apart, apart) + (r - s) * (r + s)) - dot(apart, seam.middle - set_.centres[k]);
    const Vector3 in_plane = apart - part_along(apart, seam.axis);
    const double slope = norm(in_plane);
    if (slope == 0.0 || std::fabs(height) >= slope * seam.radius)
      continue;
    const double along = height / slope,
                 aside = std::sqrt(seam.radius * seam.radius - along * along);
    const Vector3 u = (1.0 / slope) * in_plane, v = cross(seam.axis, u);
    for (const double side : {-1.0, 1.0}) {
      const Vector3 q = seam.middle + along * u + side * aside * v;
      if (norm(q - point) < reached && is_on_surface(set_, q))
        reached = norm(q - point);
    }
  }
  return reached;
}

} // namespace ellipsoid::post
