// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The surface of a union of spheres: points on it, and the distance from it.
#pragma once

#include "multisphere/clump.h"

#include <vector>

namespace ellipsoid::post {

/// A point of a surface and the area that it stands for.
struct SurfacePoint {
  Vector3 position;
  double area = 0.0; ///< (length^2)
};

/// Points spread evenly over the uncovered parts of the spheres, about `count` over all spheres.
std::vector<SurfacePoint> union_surface_points(const SphereSet& set, int count);

/// Whether no sphere holds the point in its inside; one on a sphere counts as outside of it.
bool is_on_surface(const SphereSet& set, const Vector3& point);

/// Of the unit sphere: a lattice of the golden angle.
std::vector<Vector3> unit_sphere_points(int count);

/// Distance of points from the surface of a union, inside or outside (length, >= 0).
class UnionDistance {
 public:
  explicit UnionDistance(const SphereSet& set) : set_(set) {}

  /// Exact, outside and inside.
  double from(const Vector3& point) const;

 private:
  double from_seams(const Vector3& point, double reached) const;
  double from_corners(const Vector3& point, std::size_t k, std::size_t l,
                      const std::vector<std::size_t>& near, double reached) const;

  const SphereSet& set_;
};

} // namespace ellipsoid::post
