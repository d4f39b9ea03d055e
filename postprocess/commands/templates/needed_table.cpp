// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid_counts.h"
#include "sphere_sets.h"

#include <stdexcept>

namespace ellipsoid::post {
namespace {

/// No value where no number is enough.
Value number_needed(const Vector3& semiaxes, SphereSpacing spacing, double share) {
  try {
    return static_cast<std::int64_t>(count_within(semiaxes, spacing, SetError::volume, share));
  } catch (const std::invalid_argument&) {
    return {};
  }
}

} // namespace

Table needed_table(double share, const std::vector<double>& ratios) {
  Table table{"Sub-spheres needed", {}};
  for (const double b : ratios)
    for (const double c : ratios) {
      if (c > b || c >= 1.0)
        continue;
      const Vector3 semiaxes{1.0, b, c};
      table.rows.push_back(
          {{"b_a", "b/a", "", b},
           {"c_a", "c/a", "", c},
           {"medial", "medial", "", number_needed(semiaxes, SphereSpacing::medial, share)},
           {"minimax_volume", "minimax_volume", "",
            number_needed(semiaxes, SphereSpacing::minimax_volume, share)}});
    }
  return table;
}

} // namespace ellipsoid::post
