// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The triangles of fix mesh/surface near each particle.
//
// Which triangles are near a particle is taken from the host's lists when these are new. Of them
// only some are looked at in a time step, those within reach: the others are farther from the
// particle than it, and the meshes, have moved since their gaps were measured.
#pragma once

#include "pointers.h"
#include "wall/mesh_contact.h"

#include <cmath>
#include <cstddef>
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

  /// To be called once per time step, before all else: takes new lists of near triangles and owned
  /// particles of a group, and follows meshes that move.
  /// @return whether the lists are new
  bool update(LAMMPS_NS::FixMeshSurface** meshes, int count, int groupbit);

  /// Calls visit(particle) for each particle with near triangles; select() is about it then.
  template <class Visit> void for_each_particle(const Visit& visit) {
    for (current_ = 0; current_ < particles_.size(); ++current_)
      visit(particles_[current_].particle);
  }

  /// Puts the triangles within reach of the present particle into triangles().
  /// @param[in] make_body gives the particle as it is now, for smallest_gap()
  /// @return whether there are any
  template <class MakeBody> bool select(const MakeBody& make_body) {
    Particle& particle = particles_[current_];
    if (!(moved(particle) < particle.free_way))
      measure_gaps(particle, make_body());
    if (particle.count == 0)
      return false;
    update_triangles(particle);
    return true;
  }

  /// Of triangles(), by the index there.
  const NearTriangle& near(int triangle) const {
    return reach_[particles_[current_].first + static_cast<std::size_t>(triangle)];
  }
  /// Tells triangles of all meshes apart; 0 for what is no triangle (index -1).
  double code(int triangle) const {
    return triangle < 0 ? 0.0 : 1.0 + near(triangle).id + 4294967296.0 * near(triangle).mesh;
  }
  /// Relative to the particle's centre.
  const std::vector<ellipsoid::Triangle>& triangles() const { return triangles_; }
  /// For find_mesh_contacts(): whether two triangles are parts of one flat or curved surface; the
  /// mesh's setting `curvature` decides.
  bool same_surface(int first, int second) const;
  /// Velocity of a point of a near triangle.
  ellipsoid::Vector3 velocity(int triangle, const ellipsoid::Vector3& point) const;
  /// For WallHistory: whether the triangle of that code is near and shares a corner with the other.
  bool adjoining(double code, int triangle) const;

 private:
  /// A particle and its near triangles, of which those within reach are a part.
  struct Particle {
    int particle = 0;
    std::size_t first = 0, last = 0;   ///< of its near triangles in pairs_
    std::size_t count = 0;             ///< of those within reach: from `first` on in reach_
    ellipsoid::Vector3 centre;         ///< when the gaps were measured (length)
    ellipsoid::Quaternion orientation; ///< the same
    double way = 0.0;                  ///< of the meshes until then (length)
    double free_way = -1.0;            ///< that leaves the others out of reach (length)
  };

  LAMMPS_NS::FixMeshSurface** meshes_ = nullptr;
  std::vector<NearTriangle> pairs_;              // of all particles
  std::vector<NearTriangle> reach_;              // those within reach
  std::vector<ellipsoid::Triangle> reach_nodes_; // of these, in space, when gaps were measured
  std::vector<Particle> particles_;
  std::size_t current_ = 0;
  std::vector<ellipsoid::Triangle> triangles_; // of the present one, relative to its centre
  std::vector<char> is_moving_;                // per mesh
  std::vector<NearTriangle> moving_;           // one entry per near triangle of meshes that move
  std::vector<ellipsoid::Triangle> positions_; // of these, in the last step
  double way_ = 0.0; // the largest of any corner, added up over the steps (length)

  ellipsoid::Triangle nodes(const NearTriangle& triangle) const;
  ellipsoid::Triangle relative(ellipsoid::Triangle triangle, int particle) const;
  void collect(int count, int groupbit);
  void collect_triangle(int mesh, int index, int groupbit);
  void follow_moving();
  double moved(const Particle& particle) const;
  void update_triangles(const Particle& particle);
  double margin(const Particle& particle) const;

  template <class Body> void measure_gaps(Particle& particle, const Body& body) {
    begin_measuring(particle);
    const double reach = reach_of(particle);
    double nearest_other = HUGE_VAL;
    for (std::size_t k = particle.first; k < particle.last; ++k) {
      const ellipsoid::Triangle in_space = nodes(pairs_[k]);
      const double gap = smallest_gap(body, relative(in_space, particle.particle));
      if (gap > reach) {
        nearest_other = std::fmin(nearest_other, gap);
        continue;
      }
      const std::size_t n = particle.first + particle.count++;
      reach_[n] = pairs_[k];
      reach_nodes_[n] = in_space;
    }
    particle.free_way = nearest_other - margin(particle);
  }
  void begin_measuring(Particle& particle) const;
  double reach_of(const Particle& particle) const;
};

} // namespace ellipsoid_host
