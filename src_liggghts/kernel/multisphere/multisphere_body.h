// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The spheres of a template, prepared for the search, and a body made of them in space.
//
// A body is a chain, with all centres on its x axis, or any set of spheres. Its template is built
// once and shared by all bodies of that shape, of any size.
#pragma once

#include "math/vector3.h"
#include "multisphere/clump.h"
#include "multisphere/multisphere_template.h"
#include "multisphere/sphere_tree.h"
#include "neighbours/body_bounds.h"

#include <algorithm>
#include <vector>

namespace ellipsoid {

constexpr double concavity_rounding = 1e-14; ///< relative to the largest radius

class MultisphereBody {
 public:
  /// A chain.
  /// @throws std::invalid_argument centres not ascending, radii not positive or not a concave
  ///         function of the centres (every chain of make_multisphere() is)
  explicit MultisphereBody(const MultisphereTemplate& geometry);
  /// Any set of spheres.
  /// @throws std::invalid_argument what check_spheres() refuses
  explicit MultisphereBody(const SphereSet& set);

  bool is_chain() const { return !abscissae_.empty(); }
  int count() const { return static_cast<int>(radii_.size()); }
  const Vector3& centre(int k) const { return centres_[static_cast<std::size_t>(k)]; }
  double radius(int k) const { return radii_[static_cast<std::size_t>(k)]; }
  double half_length() const { return half_length_; } ///< largest |centre| (length)
  double reach() const { return reach_; } ///< largest |centre| + radius: of the bounding sphere
  double largest_radius() const { return largest_radius_; }
  double smallest_radius() const { return *std::min_element(radii_.begin(), radii_.end()); }
  const SphereTree& tree() const { return tree_; }
  const BodyBounds& bounds() const { return bounds_; }

  /// Whether the body's origin sees the sphere's centre within the body: the straight way is
  /// covered by spheres. So it is for every sphere of a chain.
  bool is_seen_from_origin(int k) const { return seen_[static_cast<std::size_t>(k)]; }

  /// Of a chain only: x of the centre.
  double abscissa(int k) const { return abscissae_[static_cast<std::size_t>(k)]; }
  double steepest_radius() const { return steepest_radius_; } ///< largest |dR/dx| of neighbours
  /// Smallest index whose centre is >= x; count() if there is none.
  int first_at_or_after(double x) const;

 private:
  std::vector<double> abscissae_; // of a chain
  std::vector<double> radii_;
  std::vector<Vector3> centres_;
  std::vector<bool> seen_;
  double half_length_ = 0.0, reach_ = 0.0, largest_radius_ = 0.0, steepest_radius_ = 0.0;
  SphereTree tree_;
  BodyBounds bounds_;

  void measure();
};

/// One body in space: its spheres, the directions of its x and y axes, its size.
struct MultispherePose {
  const MultisphereBody* body = nullptr;
  Vector3 axis{1.0, 0.0, 0.0};        ///< unit: the body's x axis in space
  double scale = 1.0;                 ///< particle's length / template's length
  Vector3 second_axis{0.0, 1.0, 0.0}; ///< unit: its y axis; not used for chains
};

inline void turn(MultispherePose& pose, const Rotation3& orientation) {
  pose.axis = orientation.column_x;
  pose.second_axis = orientation.column_y;
}

/// Any one of the unit vectors across a unit vector.
Vector3 normal_across(const Vector3& axis);

/// Of a chain any frame about its axis.
inline Rotation3 orientation_of(const MultispherePose& pose) {
  const Vector3 second = pose.body->is_chain() ? normal_across(pose.axis) : pose.second_axis;
  return {pose.axis, second, cross(pose.axis, second)};
}

/// Centres of a body's spheres, relative to its own centre, in space (length).
class SphereCentres {
 public:
  explicit SphereCentres(const MultispherePose& pose) : pose_(pose) {
    if (!pose.body->is_chain())
      third_axis_ = cross(pose.axis, pose.second_axis);
  }
  Vector3 at(int k) const {
    if (pose_.body->is_chain())
      return (pose_.scale * pose_.body->abscissa(k)) * pose_.axis;
    const Vector3& c = pose_.body->centre(k);
    return (pose_.scale * c.x) * pose_.axis + (pose_.scale * c.y) * pose_.second_axis +
           (pose_.scale * c.z) * third_axis_;
  }
  double radius(int k) const { return pose_.scale * pose_.body->radius(k); }

 private:
  const MultispherePose& pose_;
  Vector3 third_axis_;
};

/// Upper bound of how far a body reaches in a direction from its centre (length).
double largest_reach(const MultispherePose& pose, const Vector3& direction);

} // namespace ellipsoid
