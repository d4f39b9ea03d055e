// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame.h"
#include "vector3.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// Magnitudes of contact forces (paper-independent: the usual measures of force chains).
struct ForceStatistics {
  std::size_t count = 0;
  double mean = 0.0, largest = 0.0;
  double strong_share = 0.0;        ///< forces above the mean, share of the number
  double strong_load_share = 0.0;   ///< the same, share of the sum
  std::vector<double> distribution; ///< density of f / mean in bins 0.25 wide from 0
};

/// Vectors from three named columns; with `to_unit` scaled to length 1 (zero vectors left out).
std::vector<Vector3> vectors_of(const Frame& frame, const std::vector<std::string>& columns,
                                bool to_unit);

ForceStatistics force_statistics(const std::vector<Vector3>& forces);

} // namespace ellipsoid::post
