// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contact_forces.h"

#include <algorithm>

namespace ellipsoid::post {

std::vector<Vector3> vectors_of(const Frame& frame, const std::vector<std::string>& columns,
                                bool to_unit) {
  const auto& x = frame.required(columns.at(0), "first component");
  const auto& y = frame.required(columns.at(1), "second component");
  const auto& z = frame.required(columns.at(2), "third component");
  std::vector<Vector3> vectors;
  for (std::size_t row = 0; row < frame.rows; ++row) {
    const Vector3 v{x[row], y[row], z[row]};
    const double length = norm(v);
    if (!to_unit)
      vectors.push_back(v);
    else if (length > 0.0)
      vectors.push_back((1.0 / length) * v);
  }
  return vectors;
}

ForceStatistics force_statistics(const std::vector<Vector3>& forces) {
  constexpr double bin_width = 0.25;
  constexpr std::size_t bins = 24; // up to six times the mean
  ForceStatistics result;
  result.count = forces.size();
  result.distribution.assign(bins, 0.0);
  const double count = static_cast<double>(std::max<std::size_t>(1, forces.size()));
  for (const Vector3& f : forces) {
    result.mean += norm(f) / count;
    result.largest = std::max(result.largest, norm(f));
  }
  if (!(result.mean > 0.0))
    return result;
  for (const Vector3& f : forces) {
    const double share = norm(f) / result.mean;
    const auto bin = static_cast<std::size_t>(share / bin_width);
    if (bin < bins)
      result.distribution[bin] += 1.0 / (count * bin_width);
    if (share > 1.0) {
      result.strong_share += 1.0 / count;
      result.strong_load_share += share / count;
    }
  }
  return result;
}

} // namespace ellipsoid::post
