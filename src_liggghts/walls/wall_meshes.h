// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The triangles of fix mesh/surface near each particle.
#ifndef ELLIPSOID_WALL_MESHES_H
#define ELLIPSOID_WALL_MESHES_H

#include "pointers.h"
#include "wall/mesh_contact.h"

#include <vector>

namespace LAMMPS_NS {
class FixMeshSurface;
}

namespace ellipsoid_host {

class WallMeshes : private LAMMPS_NS::Pointers {
 public:
  explicit WallMeshes(LAMMPS_NS::LAMMPS* lmp) : Pointers(lmp) {}

  struct NearTriangle {
    int particle = 0;
    int mesh = 0;  ///< number in the list of meshes
    int index = 0; ///< on this rank
    int id = 0;    ///< the same on all ranks
  };

  /// Finds all near pairs of triangles and owned particles of a group, from the host's lists.
  void collect(LAMMPS_NS::FixMeshSurface** meshes, int count, int groupbit);

  /// Calls visit(particle) for each particle with near triangles; these are at hand then.
  template <class Visit> void for_each_particle(const Visit& visit) {
    for (std::size_t first = 0; first < pairs_.size();) {
      first = select(first);
      visit(near_.front().particle);
    }
  }

  /// Of the particle's near triangles, by their index in triangles().
  const NearTriangle& near(int triangle) const { return near_[static_cast<std::size_t>(triangle)]; }
  /// Tells triangles of all meshes apart; 0 for what is no triangle (index -1).
  double code(int triangle) const {
    return triangle < 0 ? 0.0 : 1.0 + near(triangle).id + 4294967296.0 * near(triangle).mesh;
  }
  const std::vector<ellipsoid::Triangle>& triangles() const { return triangles_; }
  /// For find_mesh_contacts(): the meshes' own angle `curvature` decides.
  bool same_surface(int first, int second) const;
  /// Velocity of a point of a near triangle.
  ellipsoid::Vector3 velocity(int triangle, const ellipsoid::Vector3& point) const;
  /// For WallHistory: whether the triangle of that code is near and shares a corner with the other.
  bool adjoining(double code, int triangle) const;

 private:
  LAMMPS_NS::FixMeshSurface** meshes_ = nullptr;
  std::vector<NearTriangle> pairs_, near_;     // of all particles, of the present one
  std::vector<ellipsoid::Triangle> triangles_; // of the present one, relative to its centre

  ellipsoid::Triangle nodes(int mesh, int index) const;
  void collect_triangle(int mesh, int index, int groupbit);
  std::size_t select(std::size_t first);
};

} // namespace ellipsoid_host

#endif
