// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How well a mixture is mixed: a number q of every particle (1 or 0 for a component, or a size) is
// compared between cells, with the mean positions, and between neighbours.
#pragma once

#include "particles.h"
#include "periodic_cell.h"

#include <vector>

namespace ellipsoid::post {

struct MixingOptions {
  double cell_size = 0.0;      ///< of the cells in which particles are counted (length)
  std::size_t neighbours = 12; ///< of each particle, for the index by neighbours
  std::vector<double> weights; ///< of the particles, for example volumes; empty: all count alike
};

struct Mixing {
  std::size_t particles = 0, cells = 0;  ///< cells that are not empty
  double mean = 0.0;                     ///< of q
  double variance = 0.0;                 ///< S^2: of the cells' means, weighted by their particles
  double variance_segregated = 0.0;      ///< S0^2: every cell of one kind
  double variance_random = 0.0;          ///< SR^2: the mean over all random orders
  double lacey = 0.0, lacey_error = 0.0; ///< 0 segregated, 1 random
  double intensity = 0.0, intensity_random = 0.; ///< of segregation: S^2 / S0^2
  double intensity_error = 0.0, relative_deviation_error = 0.0;
  double relative_deviation = 0.0; ///< S / mean
  double relative_deviation_random = 0.0, relative_deviation_segregated = 0.0;
  double mean_position = 0.0, mean_position_error = 0.0; ///< generalised mean mixing index
  double mean_position_x = 0.0, mean_position_y = 0.0, mean_position_z = 0.0;
  double mean_position_lowest = 0.0, mean_position_highest = 0.0; ///< of segregated ones
  double neighbour_index = 0.0, neighbour_index_error = 0.0;      ///< 0 segregated, 1 random
};

/// Throws InputError where all values are equal.
/// @param[in] values q of every particle, >= 0
Mixing mixing(const ParticleSet& set, const std::vector<double>& values, const PeriodicCell& cell,
              const MixingOptions& options);

} // namespace ellipsoid::post
