// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <vector>

namespace ellipsoid::post {

/// In a plane, of a union of discs.
struct Disc {
  double x = 0.0, y = 0.0, radius = 0.0; ///< (length)
};

struct DiscUnion {
  double area = 0.0;      ///< each point counted once (length^2)
  double perimeter = 0.0; ///< of the outside, and of closed hollows (length)
};

/// Exact, by the arcs of each disc that lie in no other.
DiscUnion measure_discs(const std::vector<Disc>& discs);

} // namespace ellipsoid::post
