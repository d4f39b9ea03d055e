// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall_meshes.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "fix_mesh_surface.h"
#include "fix_neighlist_mesh.h"
#include "neighbor.h"
#include "wall/wall_tolerances.h"

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace LAMMPS_NS;
using ellipsoid::Vector3;

namespace ellipsoid_host {

namespace {

/// Triangles with a smaller gap than this share of the bounding radius are within reach: they are
/// looked at in every step, the others only after the particle has moved as far.
constexpr double reach_share = 0.01;

} // namespace

ellipsoid::Triangle WallMeshes::nodes(const NearTriangle& triangle) const {
  ellipsoid::Triangle t;
  for (int k = 0; k < 3; ++k) {
    double node[3];
    meshes_[triangle.mesh]->triMesh()->node(triangle.index, k, node);
    t[static_cast<std::size_t>(k)] = vector(node);
  }
  return t;
}

/// @param[in] triangle in space; relative to the particle's centre it is returned
ellipsoid::Triangle WallMeshes::relative(ellipsoid::Triangle triangle, int particle) const {
  const Vector3 centre = vector(atom->x[particle]);
  for (Vector3& node : triangle)
    node -= centre;
  return triangle;
}

bool WallMeshes::update(FixMeshSurface** meshes, int count, int groupbit) {
  const bool is_new = neighbor->ago == 0 || !meshes_;
  meshes_ = meshes;
  if (is_new)
    collect(count, groupbit);
  else
    follow_moving();
  return is_new;
}

void WallMeshes::collect(int count, int groupbit) {
  pairs_.clear();
  moving_.clear();
  positions_.clear();
  particles_.clear();
  is_moving_.clear();
  for (int m = 0; m < count; ++m) {
    const bool moves = meshes_[m]->triMesh()->isMoving() || meshes_[m]->triMesh()->isDeforming();
    is_moving_.push_back(moves ? 1 : 0);
    const int triangles = meshes_[m]->triMesh()->sizeLocal() + meshes_[m]->triMesh()->sizeGhost();
    for (int t = 0; t < triangles; ++t)
      collect_triangle(m, t, groupbit);
  }
  // in an order that does not depend on the number of ranks
  std::sort(pairs_.begin(), pairs_.end(), [](const NearTriangle& a, const NearTriangle& b) {
    return std::tie(a.particle, a.mesh, a.id, a.index) <
           std::tie(b.particle, b.mesh, b.id, b.index);
  });
  reach_.resize(pairs_.size());
  reach_nodes_.resize(pairs_.size());
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (k == 0 || pairs_[k].particle != pairs_[k - 1].particle) {
      particles_.emplace_back();
      particles_.back().particle = pairs_[k].particle;
      particles_.back().first = k;
    }
    particles_.back().last = k + 1;
  }
}

void WallMeshes::collect_triangle(int mesh, int index, int groupbit) {
  const std::vector<int>& near = meshes_[mesh]->meshNeighlist()->get_contact_list(index);
  NearTriangle pair;
  pair.mesh = mesh;
  pair.index = index;
  pair.id = meshes_[mesh]->triMesh()->id(index);
  const std::size_t before = pairs_.size();
  for (const int i : near) {
    if (i >= atom->nlocal || !(atom->mask[i] & groupbit))
      continue;
    pair.particle = i;
    pairs_.push_back(pair);
  }
  if (pairs_.size() == before || !is_moving_[static_cast<std::size_t>(mesh)])
    return;
  moving_.push_back(pair);
  positions_.push_back(nodes(pair));
}

/// Adds the largest displacement of any corner to the way.
void WallMeshes::follow_moving() {
  double largest_square = 0.0;
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    const ellipsoid::Triangle now = nodes(moving_[k]);
    for (std::size_t n = 0; n < 3; ++n) {
      const Vector3 step = now[n] - positions_[k][n];
      largest_square = std::max(largest_square, dot(step, step));
    }
    positions_[k] = now;
  }
  way_ += std::sqrt(largest_square);
}

/// A bound of the way of any point of the particle, and of any triangle, since the gaps were
/// measured: with q0 and q the quaternions then and now it has turned by twice the angle whose
/// cosine is q0.q.
double WallMeshes::moved(const Particle& particle) const {
  const int i = particle.particle;
  const Vector3 way = vector(atom->x[i]) - particle.centre;
  const ellipsoid::Quaternion now = quaternion(atom->quaternion[i]), &then = particle.orientation;
  const double cosine = now.w * then.w + now.x * then.x + now.y * then.y + now.z * then.z;
  const double half_chord = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  return norm(way) + 2.0 * half_chord * atom->radius[i] + (way_ - particle.way);
}

void WallMeshes::begin_measuring(Particle& particle) const {
  const int i = particle.particle;
  particle.centre = vector(atom->x[i]);
  particle.orientation = quaternion(atom->quaternion[i]);
  particle.way = way_;
  particle.count = 0;
}

double WallMeshes::reach_of(const Particle& particle) const {
  return reach_share * atom->radius[particle.particle];
}

/// Triangles so near a contact's foot matter for it.
double WallMeshes::margin(const Particle& particle) const {
  return ellipsoid::wall_tolerance::same_plane * atom->radius[particle.particle];
}

void WallMeshes::update_triangles(const Particle& particle) {
  triangles_.clear();
  for (std::size_t k = particle.first; k < particle.first + particle.count; ++k) {
    const bool is_moving = is_moving_[static_cast<std::size_t>(reach_[k].mesh)];
    triangles_.push_back(
        relative(is_moving ? nodes(reach_[k]) : reach_nodes_[k], particle.particle));
  }
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
  const double margin =
      ellipsoid::wall_tolerance::unmatched * atom->radius[particles_[current_].particle];
  for (std::size_t k = 0; k < triangles_.size(); ++k)
    if (code(static_cast<int>(k)) == former && adjoin(triangles_[k], other, margin))
      return true;
  return false;
}

} // namespace ellipsoid_host
