// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/sphere_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ellipsoid {
namespace {

/// Bounds are widened by this share: a few roundings of their coordinates.
constexpr double bound_rounding = 1e-12;

double component(const Vector3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

using Indices = std::vector<int>::iterator;

class Builder {
 public:
  Builder(const std::vector<Vector3>& centres, const std::vector<double>& radii,
          std::vector<SphereTree::Node>& nodes)
      : centres_(centres), radii_(radii), nodes_(nodes) {}

  /// Adds the tree of some spheres. @return the depth of its deepest leaf
  int add(Indices begin, Indices end) {
    const std::size_t index = nodes_.size();
    if (end - begin == 1) {
      nodes_.push_back({centre(*begin), radius(*begin), -1, *begin});
      return 0;
    }
    double low[3], high[3];
    extent(begin, end, low, high);
    nodes_.push_back(bound(begin, end, low, high));
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (high[k] - low[k] > high[axis] - low[axis])
        axis = k;
    const Indices middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](int k, int l) {
      const double a = component(centre(k), axis), b = component(centre(l), axis);
      return a != b ? a < b : k < l;
    });
    const int first_depth = add(begin, middle);
    nodes_[index].second = static_cast<int>(nodes_.size());
    return 1 + std::max(first_depth, add(middle, end));
  }

 private:
  const std::vector<Vector3>& centres_;
  const std::vector<double>& radii_;
  std::vector<SphereTree::Node>& nodes_;

  const Vector3& centre(int k) const { return centres_[static_cast<std::size_t>(k)]; }
  double radius(int k) const { return radii_[static_cast<std::size_t>(k)]; }

  /// Corners of the box around the spheres.
  void extent(Indices begin, Indices end, double* low, double* high) const {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = HUGE_VAL;
      high[axis] = -HUGE_VAL;
      for (Indices k = begin; k != end; ++k) {
        low[axis] = std::fmin(low[axis], component(centre(*k), axis) - radius(*k));
        high[axis] = std::fmax(high[axis], component(centre(*k), axis) + radius(*k));
      }
    }
  }

  /// A sphere about the middle of the box.
  SphereTree::Node bound(Indices begin, Indices end, const double* low, const double* high) const {
    const Vector3 middle{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]),
                         0.5 * (low[2] + high[2])};
    double reach = 0.0;
    for (Indices k = begin; k != end; ++k)
      reach = std::fmax(reach, norm(centre(*k) - middle) + radius(*k));
    return {middle, reach * (1.0 + bound_rounding), -1, -1};
  }
};

} // namespace

SphereTree::SphereTree(const std::vector<Vector3>& centres, const std::vector<double>& radii) {
  std::vector<int> order(radii.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.reserve(2 * radii.size());
  depth_ = Builder(centres, radii, nodes_).add(order.begin(), order.end());
}

} // namespace ellipsoid
