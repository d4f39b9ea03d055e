// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "spread.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {

Spread spread_of(const std::vector<double>& values) {
  Spread s;
  s.count = values.size();
  if (values.empty())
    return s;
  const auto n = static_cast<double>(values.size());
  const auto range = std::minmax_element(values.begin(), values.end());
  s.lowest = *range.first;
  s.highest = *range.second;
  s.half_range = 0.5 * (s.highest - s.lowest);
  for (const double value : values)
    s.mean += value / n;
  double squares = 0.0;
  for (const double value : values)
    squares += (value - s.mean) * (value - s.mean);
  s.standard_deviation = values.size() > 1 ? std::sqrt(squares / (n - 1.0)) : 0.0;
  return s;
}

} // namespace ellipsoid::post
