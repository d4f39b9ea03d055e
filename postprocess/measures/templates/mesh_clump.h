// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Spheres for the body that a closed surface encloses.
#pragma once

#include "closed_mesh.h"
#include "multisphere/multisphere_template.h"
#include "sphere_set_measures.h"

#include <memory>

namespace ellipsoid::post {

/// Largest inscribed balls of the body, in an order in which each adds the most volume to those
/// before it and touches them.
///
/// A ball that touches the surface at a point shrinks until no other part of the surface is in it
/// (Ma, Bae, Choi: 3D medial axis point approximation using nearest neighbors and the normal field,
/// The Visual Computer 28 (2012) 7-19); its centre lies on the medial axis then.
class MeshClumps {
 public:
  explicit MeshClumps(std::vector<Triangle3> closed_triangles);

  const Solid& solid() const { return solid_; }
  /// How many balls add volume, on the grid on which volume is counted.
  int largest_count() const { return balls_.count(); }

  /// The first `count` balls. With spacing `minimax_volume` all radii grow by one length, so that
  /// the volume in exactly one of body and spheres is smallest.
  /// Throws InputError when there are not so many, or for a spacing of chains.
  SphereSet spheres(int count, SphereSpacing spacing) const;
  /// The smallest number within a share of the volume in exactly one of the two.
  /// Throws InputError when all are not enough.
  int count_for(double tolerance, SphereSpacing spacing) const;

 private:
  std::vector<Triangle3> triangles_;
  std::shared_ptr<const TriangleTree> tree_;
  Solid solid_;
  SphereSet balls_;
};

} // namespace ellipsoid::post
