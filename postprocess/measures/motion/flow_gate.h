// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "math/vector3.h"
#include "periodic_cell.h"

#include <array>
#include <optional>
#include <vector>

namespace ellipsoid::post {

/// Where particles are counted. Forward is the way of the normal (of triangles: the right hand).
struct FlowGate {
  Vector3 point, normal{0.0, 0.0, 1.0};          ///< of the plane; normal: unit
  std::optional<double> radius;                  ///< of a disc about the point (length)
  std::vector<std::array<Vector3, 3>> triangles; ///< if any: instead of plane and disc

  bool is_bounded() const { return radius || !triangles.empty(); }
  /// Whether a point of the plane belongs to it (not needed of triangles).
  bool holds(const Vector3& position) const;
};

/// A way from one point straight to another through a gate.
struct GateCrossing {
  int direction = 0;        ///< +1 forward, -1 backward
  double share = 0.0;       ///< of the way, where it crosses: 0 to 1
  Vector3 position, normal; ///< there; normal: unit, forward
};

/// Where a gate lies in a cell, in shares of its edges.
struct SharesOfEdges {
  std::array<double, 3> least{}, greatest{};
};
/// Of a disc or of triangles; of an endless plane: those of its point.
SharesOfEdges shares_of_edges(const FlowGate& gate, const PeriodicCell& cell);

/// All crossings of the way. A gate belongs to the side to which its normal points, and edges that
/// triangles share to one of them: ways that follow each other are counted once.
std::vector<GateCrossing> crossings(const FlowGate& gate, const Vector3& from, const Vector3& to);

} // namespace ellipsoid::post
