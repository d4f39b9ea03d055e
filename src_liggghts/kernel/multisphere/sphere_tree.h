// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A bounding-volume hierarchy over the spheres of a body: a binary tree whose nodes are spheres
// that hold those below them; each leaf is one of the body's spheres itself.
//
// Two trees are walked together from their roots: a pair of nodes farther apart than the gap
// sought is left with all below it, of any other the larger node is opened. Nothing is missed, as
// a node holds its spheres, and what is opened is near.
#pragma once

#include "math/vector3.h"

#include <vector>

namespace ellipsoid {

class SphereTree {
 public:
  struct Node {
    Vector3 centre; ///< in the body's frame (length)
    double radius;  ///< of a sphere that holds all below (length)
    int second;     ///< of an inner node: its second child, the first one is the next node
    int sphere;     ///< of a leaf: its number; -1 for an inner node
  };

  SphereTree() = default;
  /// @param[in] centres, radii of at least one sphere (length)
  SphereTree(const std::vector<Vector3>& centres, const std::vector<double>& radii);

  const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  int depth() const { return depth_; } ///< of the deepest leaf, the root's is 0

 private:
  std::vector<Node> nodes_; // the root is the first one
  int depth_ = 0;
};

/// Body j seen from body i: a point p of j is at offset + (x, y, z) p in i's frame.
struct RelativePose {
  Vector3 offset, x, y, z; ///< x, y, z have the length scale_j / scale_i: all in lengths of i
  double ratio;            ///< scale_j / scale_i
};

/// The largest depth of a tree: its halves differ by one sphere at most, 2^14 > 9999.
constexpr int largest_tree_depth = 14;

/// Calls visit(sphere of i, sphere of j, gap between them) for all pairs not farther apart than
/// `gap`. Lengths are those of i's template.
/// @param[in] gap may become smaller in the visits: what is farther is left out then
/// @return how many distances between spheres were computed, those of nodes not counted
template <class Visit>
int for_each_pair_within(const SphereTree& i, const SphereTree& j, const RelativePose& pose,
                         const double& gap, const Visit& visit) {
  struct NodePair {
    int i, j;
  };
  // Each opening replaces one entry by two: the depth of both trees, and one, are on the stack.
  NodePair stack[2 * largest_tree_depth + 2];
  int entries = 1, tested = 0;
  stack[0] = {0, 0};
  while (entries > 0) {
    const NodePair pair = stack[--entries];
    const SphereTree::Node &a = i.node(pair.i), &b = j.node(pair.j);
    const Vector3 way =
        pose.offset + (b.centre.x * pose.x + b.centre.y * pose.y + b.centre.z * pose.z) - a.centre;
    const double radius_b = pose.ratio * b.radius, reach = a.radius + radius_b + gap;
    const bool are_leaves = a.sphere >= 0 && b.sphere >= 0;
    tested += are_leaves;
    const double squared = dot(way, way);
    if (!(reach > 0.0 && squared <= reach * reach))
      continue;
    if (are_leaves) {
      visit(a.sphere, b.sphere, std::sqrt(squared) - a.radius - radius_b);
    } else if (b.sphere >= 0 || (a.sphere < 0 && a.radius >= radius_b)) {
      stack[entries++] = {a.second, pair.j};
      stack[entries++] = {pair.i + 1, pair.j};
    } else {
      stack[entries++] = {pair.i, b.second};
      stack[entries++] = {pair.i, pair.j + 1};
    }
  }
  return tested;
}

} // namespace ellipsoid
