// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall_meshes.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "fix_mesh_surface.h"
#include "fix_neighlist_mesh.h"
#include "wall/wall_tolerances.h"

#include <algorithm>
#include <tuple>

using namespace LAMMPS_NS;
using ellipsoid::Vector3;

namespace ellipsoid_host {

namespace {

/// Triangles within so many radii of the bounding sphere are near: a little more than can be
/// touched.
constexpr double near_reach = 1.01;

} // namespace

ellipsoid::Triangle WallMeshes::nodes(int mesh, int index) const {
  ellipsoid::Triangle triangle;
  for (int k = 0; k < 3; ++k) {
    double node[3];
    meshes_[mesh]->triMesh()->node(index, k, node);
    triangle[static_cast<std::size_t>(k)] = vector(node);
  }
  return triangle;
}

void WallMeshes::collect(FixMeshSurface** meshes, int count, int groupbit) {
  meshes_ = meshes;
  pairs_.clear();
  for (int m = 0; m < count; ++m) {
    const int triangles = meshes_[m]->triMesh()->sizeLocal() + meshes_[m]->triMesh()->sizeGhost();
    for (int t = 0; t < triangles; ++t)
      collect_triangle(m, t, groupbit);
  }
  // in an order that does not depend on the number of ranks
  std::sort(pairs_.begin(), pairs_.end(), [](const NearTriangle& a, const NearTriangle& b) {
    return std::tie(a.particle, a.mesh, a.id, a.index) <
           std::tie(b.particle, b.mesh, b.id, b.index);
  });
}

void WallMeshes::collect_triangle(int mesh, int index, int groupbit) {
  const std::vector<int>& near = meshes_[mesh]->meshNeighlist()->get_contact_list(index);
  if (near.empty())
    return;
  const ellipsoid::Triangle triangle = nodes(mesh, index);
  const Vector3 normal = unit_normal(triangle);
  NearTriangle pair;
  pair.mesh = mesh;
  pair.index = index;
  pair.id = meshes_[mesh]->triMesh()->id(index);
  for (const int i : near) {
    if (i >= atom->nlocal || !(atom->mask[i] & groupbit))
      continue;
    const Vector3 centre = vector(atom->x[i]);
    const double reach = near_reach * atom->radius[i];
    if (std::fabs(dot(normal, centre - triangle[0])) > reach ||
        norm(nearest_point(triangle, centre) - centre) > reach)
      continue;
    pair.particle = i;
    pairs_.push_back(pair);
  }
}

/// Makes the pairs of one particle the present ones; returns where those of the next begin.
std::size_t WallMeshes::select(std::size_t first) {
  const int particle = pairs_[first].particle;
  const Vector3 centre = vector(atom->x[particle]);
  near_.clear();
  triangles_.clear();
  for (; first < pairs_.size() && pairs_[first].particle == particle; ++first) {
    near_.push_back(pairs_[first]);
    triangles_.push_back(nodes(pairs_[first].mesh, pairs_[first].index));
    for (Vector3& node : triangles_.back())
      node -= centre;
  }
  return first;
}

bool WallMeshes::same_surface(int first, int second) const {
  const NearTriangle &a = near(first), &b = near(second);
  return a.mesh == b.mesh && a.id != b.id &&
         meshes_[a.mesh]->triMesh()->areCoplanarNodeNeighs(a.id, b.id);
}

Vector3 WallMeshes::velocity(int triangle, const Vector3& point) const {
  const NearTriangle& pair = near(triangle);
  auto* velocities =
      meshes_[pair.mesh]->triMesh()->prop().getElementProperty<MultiVectorContainer<double, 3, 3>>(
          "v");
  if (!velocities)
    return {};
  double** v = velocities->begin()[pair.index];
  const Vector3 weights = barycentric(triangles_[static_cast<std::size_t>(triangle)], point);
  return weights.x * vector(v[0]) + weights.y * vector(v[1]) + weights.z * vector(v[2]);
}

bool WallMeshes::adjoining(double former, int triangle) const {
  const ellipsoid::Triangle& other = triangles_[static_cast<std::size_t>(triangle)];
  const double margin = ellipsoid::wall_tolerance::unmatched * atom->radius[near_.front().particle];
  for (std::size_t k = 0; k < near_.size(); ++k)
    if (code(static_cast<int>(k)) == former && adjoin(triangles_[k], other, margin))
      return true;
  return false;
}

} // namespace ellipsoid_host
