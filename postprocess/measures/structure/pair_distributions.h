// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How particles lie to each other: by the distance of their centres, by their directions, by the
// gap between their surfaces.
#pragma once

#include "particles.h"
#include "periodic_cell.h"

#include <optional>
#include <vector>

namespace ellipsoid::post {

/// A bin of the distances of centres.
struct DistanceBin {
  double begin = 0.0, end = 0.0; ///< (length)
  double g = 0.0;                ///< pairs over those of an ideal gas in the same region
  std::optional<double> g2;      ///< mean of P2(u_i . u_j) of the pairs that have directions
};

/// The largest distance of centres that pair_distribution() takes (length).
double largest_pair_distance(const ParticleSet& set, const PeriodicCell& cell);

/// g(r) and g2(r) up to `farthest` in equal bins. u: the longest semi-axes, of discs the shortest
/// ones. The region is the box along axes that repeat, and the extent of the centres along others.
/// Throws InputError for fewer than two particles, for distances beyond half of a repeating
/// edge's thickness or beyond the region, and for tilted boxes that do not repeat everywhere.
std::vector<DistanceBin> pair_distribution(const ParticleSet& set, const PeriodicCell& cell,
                                           double farthest, int bins);

/// A bin of gaps; gaps < 0 are overlaps.
struct GapBin {
  double begin = 0.0, end = 0.0; ///< (length)
  double density = 0.0;          ///< neighbours per particle and gap (1/length)
  double neighbours = 0.0;       ///< per particle with a gap below `end`
};

/// Exact gap between the surfaces of two particles, the second moved by `shift` (length).
double surface_gap(const ParticleSet& set, std::size_t i, std::size_t j, const Vector3& shift);

/// Gaps from `lowest` to `highest` in equal bins (length); deeper overlaps are in `neighbours`.
std::vector<GapBin> gap_distribution(const ParticleSet& set, const PeriodicCell& cell,
                                     double lowest, double highest, int bins);

/// The structure factor of the centres, averaged over wave vectors of about the same length.
struct StructureBin {
  double wave_number = 0.0; ///< mean of the bin's wave vectors (1/length)
  double s = 0.0;           ///< |sum of exp(i k r)|^2 / N
  std::size_t vectors = 0;
};

/// For wave vectors of a box that repeats along all edges, up to `highest` (1/length).
/// Throws InputError for other boxes.
std::vector<StructureBin> structure_factor(const ParticleSet& set, const PeriodicCell& cell,
                                           double highest, int bins);

} // namespace ellipsoid::post
