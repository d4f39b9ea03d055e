// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "flow_through.h"

#include <optional>
#include <vector>

namespace ellipsoid::post {

/// What passed one part of an opening.
struct FlowBin {
  double begin = 0.0, end = 0.0; ///< radii, or coordinates along a direction (length)
  std::optional<double> area;    ///< of rings (length^2)
  std::size_t forward = 0, backward = 0;
  double net_mass = 0.0;
  /// Means over the passages, weighted by mass: speed along the normal, forward positive, its mean
  /// square, and the speed across (velocity).
  double mass = 0.0, speed = 0.0, speed_square = 0.0, across = 0.0;
};

/// Passages by where they are in an opening: rings about the middle of a disc, or strips along a
/// direction.
class FlowProfile {
 public:
  /// Rings of equal width of a disc. @param[in] radius (length)
  static FlowProfile rings(const Vector3& middle, double radius, std::size_t count);
  /// Strips. @param[in] along unit, @param[in] begin, end of dot(along, position) (length)
  static FlowProfile strips(const Vector3& along, double begin, double end, std::size_t count);

  /// Passages of a step of this duration (time). Those beyond the bins are counted apart.
  void add(const std::vector<Passage>& passages, double duration);
  /// With the means made.
  std::vector<FlowBin> bins() const;
  std::size_t beyond() const { return beyond_; }

 private:
  FlowProfile(const Vector3& middle, const std::optional<Vector3>& along, double begin, double end,
              std::size_t count);

  Vector3 middle_;
  std::optional<Vector3> along_;
  double begin_, width_;
  std::size_t beyond_ = 0;
  std::vector<FlowBin> sums_; ///< means not divided yet
};

} // namespace ellipsoid::post
