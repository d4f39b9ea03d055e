// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Columns of tables that put a set of spheres beside its body.
#pragma once

#include "multisphere/union_measures.h"
#include "sphere_set_measures.h"
#include "table.h"

#include <optional>
#include <string>

namespace ellipsoid::post {

/// What all sets of a call are compared with, and the length that is the unit of distances.
struct Target {
  std::optional<Solid> solid;
  double unit = 1.0;
  std::string unit_name; ///< "c", the smallest semi-axis, or "r_V", of the ball of equal volume
  std::optional<Vector3> semiaxes; ///< of an ellipsoid
};

/// Volume, surface, distances of the outlines, moments, each as a share of the body's.
/// @param[in] m of the set
/// @param[in] target has a solid
void append_comparison(Row& row, const UnionMeasures& m, const SphereSet& set,
                       const Target& target);

} // namespace ellipsoid::post
