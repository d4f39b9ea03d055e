// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which periodic images of something reach a part of space, in orthogonal and in tilted cells of
// any size.
#pragma once

#include "math/vector3.h"

#include <array>
#include <vector>

namespace ellipsoid {

/// A block parallel to the axes.
struct SpaceBlock {
  Vector3 low, high; ///< corners (length)
};

struct PeriodicEdges {
  std::array<Vector3, 3> edges;        ///< x0 0, x y 0, x y z as the host's (length), all > 0
  std::array<bool, 3> is_periodic{};   ///< along each edge
  std::array<Vector3, 3> edge_speed{}; ///< by which images along the edge are faster (length/time)

  Vector3 shift(const std::array<int, 3>& image) const;
  Vector3 speed(const std::array<int, 3>& image) const;
};

/// Images, as whole numbers of edges, at which a point of `source` may lie in `target`; some more
/// than these may be among them.
std::vector<std::array<int, 3>>
images_that_reach(const PeriodicEdges& cell, const SpaceBlock& source, const SpaceBlock& target);

} // namespace ellipsoid
