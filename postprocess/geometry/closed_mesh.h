// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A closed surface of triangles: checked, measured, searched.
#pragma once

#include "solid_columns.h"

#include <array>
#include <string>
#include <vector>

namespace ellipsoid::post {

using Triangle3 = std::array<Vector3, 3>;

/// Throws InputError in one line unless every edge belongs to just two triangles, which pass it in
/// opposite directions, and the surface encloses one body, which may have hollows. Corners are the
/// same point when their coordinates are. Triangles without area are left out; all are turned
/// inside out if the volume is negative.
std::vector<Triangle3> checked_closed(std::vector<Triangle3> triangles, const std::string& name);

struct MeshMeasures {
  double volume = 0.0, surface = 0.0; ///< (length^3, length^2)
  Vector3 centre;                     ///< of mass, density constant (length)
  SymmetricMatrix3 inertia;           ///< about it, density 1 (length^5)
  SolidBox box;
};

MeshMeasures measure_mesh(const std::vector<Triangle3>& triangles);

/// A point of a surface with its outer normal.
struct MeshPoint {
  Vector3 position, normal;
};

/// Points spread by area, the same for the same mesh; each stands for the same area.
std::vector<MeshPoint> mesh_points(const std::vector<Triangle3>& triangles, int count);

/// A tree of boxes over the triangles, for the nearest point of the surface.
class TriangleTree {
 public:
  explicit TriangleTree(std::vector<Triangle3> triangles);

  /// O(log of the number of triangles) for points near the surface.
  Vector3 nearest(const Vector3& point) const;

 private:
  struct Node {
    Vector3 lower, upper;
    std::size_t begin = 0, end = 0; ///< triangles of a leaf
    std::size_t right = 0;          ///< the left child is the next node; 0: a leaf
  };
  void build(std::size_t begin, std::size_t end);
  void search(std::size_t node, const Vector3& point, double& square, Vector3& nearest) const;

  std::vector<Triangle3> triangles_;
  std::vector<Node> nodes_;
};

} // namespace ellipsoid::post
