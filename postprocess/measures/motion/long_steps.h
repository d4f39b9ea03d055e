// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Ways from frame to frame of which it is not sure that they are the shortest ones.
#pragma once

#include "periodic_cell.h"

#include <cmath>

namespace ellipsoid::post {

/// Whether a way is longer than 0.4 of an edge that repeats: the shortest of its images is at most
/// half of one, and may be another than that which was gone.
inline bool is_nearly_half_an_edge(const PeriodicCell& cell, const Vector3& way) {
  constexpr double nearly_half = 0.4;
  const Vector3 f = cell.fractions(cell.corner() + way);
  const double shares[] = {f.x, f.y, f.z};
  for (std::size_t k = 0; k < 3; ++k)
    if (cell.is_periodic(k) && std::abs(shares[k]) > nearly_half)
      return true;
  return false;
}

} // namespace ellipsoid::post
