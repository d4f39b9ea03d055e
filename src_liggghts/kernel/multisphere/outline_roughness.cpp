// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/multisphere_measures.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid {
namespace {

constexpr int intervals = 100; ///< of an arc, even: Simpson's error is below 1e-8 of the result

/// Integrals over length of 1, of the distance and of its square.
struct Sums {
  double length = 0.0, first = 0.0, second = 0.0;
};

/// Integrates over the angle from the crest: the outline is smooth in it to the chain's ends.
void add_arc(const MultisphereTemplate& chain, const OutlinePiece& piece, Sums& sums) {
  const auto k = static_cast<std::size_t>(piece.sphere);
  const double r = chain.radii[k], from = arc_angle(r, piece.begin), to = arc_angle(r, piece.end);
  for (int i = 0; i <= intervals; ++i) {
    const double angle = from + (to - from) * i / intervals;
    const double x = chain.centres[k] + r * std::sin(angle), y = r * std::cos(angle);
    const double share = i == 0 || i == intervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    const double weight = share / 3.0 * r * (to - from) / intervals;
    const double distance = piece.sign * distance_from_ellipse(chain.a, chain.b, x, y);
    sums.length += weight;
    sums.first += weight * distance;
    sums.second += weight * distance * distance;
  }
}

} // namespace

OutlineRoughness outline_roughness(const MultisphereTemplate& chain,
                                   const std::vector<CutOffSphere>& parts) {
  Sums sums; // of the upper half
  for (const OutlinePiece& piece : outline_pieces(chain, parts))
    add_arc(chain, piece, sums);
  const double mean = sums.first / sums.length, square = sums.second / sums.length;
  return {mean, std::sqrt(square), std::sqrt(std::max(0.0, square - mean * mean))};
}

} // namespace ellipsoid
