// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "averages/images_in_reach.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid {
namespace {

Vector3 sum_of(const std::array<Vector3, 3>& edges, const std::array<int, 3>& image) {
  return image[0] * edges[0] + image[1] * edges[1] + image[2] * edges[2];
}

struct Range {
  int first = 0, last = 0;
};

/// Whole numbers n with source + n * edge within the target, along one axis.
Range images_along(double edge, double source_low, double source_high, double target_low,
                   double target_high) {
  return {static_cast<int>(std::ceil((target_low - source_high) / edge)),
          static_cast<int>(std::floor((target_high - source_low) / edge))};
}

} // namespace

Vector3 PeriodicEdges::shift(const std::array<int, 3>& image) const { return sum_of(edges, image); }

Vector3 PeriodicEdges::speed(const std::array<int, 3>& image) const {
  return sum_of(edge_speed, image);
}

/// The third edge alone moves along z, then the second along y, then the first along x.
std::vector<std::array<int, 3>>
images_that_reach(const PeriodicEdges& cell, const SpaceBlock& source, const SpaceBlock& target) {
  const auto& [a, b, c] = cell.edges;
  const auto range = [](bool is_periodic, double edge, double low, double high, double from,
                        double to) {
    return is_periodic ? images_along(edge, low, high, from, to) : Range{};
  };
  std::vector<std::array<int, 3>> found;
  const Range z =
      range(cell.is_periodic[2], c.z, source.low.z, source.high.z, target.low.z, target.high.z);
  for (int k = z.first; k <= z.last; ++k) {
    const Range y = range(cell.is_periodic[1], b.y, source.low.y + k * c.y, source.high.y + k * c.y,
                          target.low.y, target.high.y);
    for (int j = y.first; j <= y.last; ++j) {
      const double skew = k * c.x + j * b.x;
      const Range x = range(cell.is_periodic[0], a.x, source.low.x + skew, source.high.x + skew,
                            target.low.x, target.high.x);
      for (int i = x.first; i <= x.last; ++i)
        found.push_back({i, j, k});
    }
  }
  return found;
}

} // namespace ellipsoid
