// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "axis_scale.h"

#include <cmath>

namespace ellipsoid::post {

double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= length * (1.0 + 1e-12))
      return digit * power;
  return power;
}

std::vector<double> round_ticks(double low, double high, int wanted) {
  std::vector<double> ticks;
  if (!(high > low))
    return {low};
  const double step = round_length(1.5 * (high - low) / wanted);
  const double slack = 1e-9 * step;
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; k += 1.0)
    ticks.push_back(k * step + 0.0);
  return ticks;
}

} // namespace ellipsoid::post
