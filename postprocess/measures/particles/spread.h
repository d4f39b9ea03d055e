// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <cstddef>
#include <vector>

namespace ellipsoid::post {

/// Several values of one quantity, as the paper gives them: average and uncertainty margin.
struct Spread {
  std::size_t count = 0;
  double mean = 0.0;
  double half_range = 0.0;         ///< (max - min) / 2, the paper's margin
  double standard_deviation = 0.0; ///< of one value, n - 1; 0 for one value
  double lowest = 0.0, highest = 0.0;
};

Spread spread_of(const std::vector<double>& values);

} // namespace ellipsoid::post
