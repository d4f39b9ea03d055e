// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "mixing.h"

#include "nearest_neighbours.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <utility>

namespace ellipsoid::post {
namespace {

/// Sums over the particles of a cell, or of all. Weights w: 1, or volumes.
struct Sums {
  double count = 0.0, weight = 0.0, values = 0.0, squares = 0.0; ///< of 1, w, w q, w q^2
  double weight_squares = 0.0, weighted_values = 0.0, weighted_squares = 0.0; ///< w^2 (1, q, q^2)
  double unlike = 0.0; ///< sum of w_i w_k (q_i - q_k)^2 over the neighbours k of its particles

  void add(double w, double q, double unlike_neighbours) {
    count += 1.0;
    weight += w;
    values += w * q;
    squares += w * q * q;
    weight_squares += w * w;
    weighted_values += w * w * q;
    weighted_squares += w * w * q * q;
    unlike += unlike_neighbours;
  }
  Sums without(const Sums& other) const {
    Sums rest = *this;
    rest.count -= other.count;
    rest.weight -= other.weight;
    rest.values -= other.values;
    rest.squares -= other.squares;
    rest.weight_squares -= other.weight_squares;
    rest.weighted_values -= other.weighted_values;
    rest.weighted_squares -= other.weighted_squares;
    rest.unlike -= other.unlike;
    return rest;
  }
};

/// Which cell a point lies in: cells are equal shares of a repeating edge, else of this size from
/// the box's corner.
class Cells {
 public:
  Cells(const PeriodicCell& cell, double size) : cell_(cell) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double parts = cell.thickness(k) / size;
      parts_[k] = cell.is_periodic(k) ? std::max(1.0, std::round(parts)) : parts;
    }
  }
  std::array<std::int64_t, 3> of(const Vector3& point) const {
    const Vector3 f = cell_.fractions(cell_.wrapped(point));
    return {number(f.x * parts_[0]), number(f.y * parts_[1]), number(f.z * parts_[2])};
  }

 private:
  static std::int64_t number(double x) { return static_cast<std::int64_t>(std::floor(x)); }
  const PeriodicCell& cell_;
  std::array<double, 3> parts_{};
};

/// The variances and the indices made of them, from sums over cells.
struct Indices {
  double variance = 0.0, segregated = 0.0, random = 0.0, lacey = 0.0, neighbours = 0.0;
  double intensity = 0.0, relative_deviation = 0.0;
};

/// What indices need beside sums.
struct IndexSettings {
  double neighbours = 0.0; ///< of each particle
  double correction = 1.0; ///< of the variance of random orders, for weights that differ
};

/// @param[in] squares_of_means sum over the cells of (sum of w q)^2 / (sum of w)
Indices indices_of(const Sums& all, double cells, double squares_of_means,
                   const IndexSettings& settings) {
  Indices result;
  const double mean = all.values / all.weight;
  result.variance = squares_of_means / all.weight - mean * mean;
  result.segregated = all.squares / all.weight - mean * mean;
  // Mean of S^2 over all orders of the particles, sampling without replacement: the sums of
  // w (q - p) in the cells vary, their weights are taken as n W / N (exact for equal weights).
  const double scatter =
      all.weighted_squares - 2.0 * mean * all.weighted_values + mean * mean * all.weight_squares;
  result.random = settings.correction * scatter * all.count / (all.weight * all.weight) *
                  (cells - 1.0) / (all.count - 1.0);
  result.lacey =
      (result.segregated - result.variance) / (result.segregated - result.random); // Lacey 1954
  // of w_i w_k (q_i - q_k)^2 over all pairs
  const double pairs = all.count * (all.count - 1.0);
  const double expected = 2.0 * (all.weight * all.squares - all.values * all.values) / pairs;
  result.neighbours = all.unlike / (all.count * settings.neighbours) / expected;
  result.intensity = result.variance / result.segregated; // Danckwerts 1952
  result.relative_deviation = std::sqrt(std::max(0.0, result.variance)) / mean;
  return result;
}

/// S^2 of particles in cells.
double variance_of(const std::vector<std::size_t>& cell_of, const std::vector<std::size_t>& order,
                   const std::vector<double>& values, const std::vector<double>& weights,
                   std::vector<std::pair<double, double>>& sums) {
  std::fill(sums.begin(), sums.end(), std::pair(0.0, 0.0));
  double weight = 0.0, total = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double w = weights[order[i]], part = w * values[order[i]];
    sums[cell_of[i]].first += w;
    sums[cell_of[i]].second += part;
    weight += w;
    total += part;
  }
  for (const auto& [w, part] : sums)
    squares += part * part / w;
  return squares / weight - total * total / (weight * weight);
}

/// Mean of S^2 over random orders of the particles (no closed form where weights differ).
double random_variance(const std::vector<std::size_t>& cell_of, std::size_t cells,
                       const std::vector<double>& values, const std::vector<double>& weights) {
  constexpr std::size_t most_orders = 2000, fewest_orders = 100, wanted_steps = 20000000;
  const std::size_t orders = std::clamp(wanted_steps / values.size(), fewest_orders, most_orders);
  std::mt19937_64 generator(20100213); // the same orders in every call
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::pair<double, double>> sums(cells);
  double mean = 0.0;
  for (std::size_t n = 0; n < orders; ++n) {
    for (std::size_t k = order.size() - 1; k > 0; --k)
      std::swap(order[k], order[generator() % (k + 1)]);
    mean += variance_of(cell_of, order, values, weights, sums) / static_cast<double>(orders);
  }
  return mean;
}

double mean_square(const Sums& cell) { return cell.values * cell.values / cell.weight; }

/// Standard error of an index from its values without one cell after the other (jackknife).
double jackknife_error(const std::vector<Indices>& left_out, double Indices::*index) {
  const double count = static_cast<double>(left_out.size());
  double mean = 0.0, squares = 0.0;
  for (const Indices& i : left_out)
    mean += i.*index / count;
  for (const Indices& i : left_out)
    squares += (i.*index - mean) * (i.*index - mean);
  return std::sqrt(squares * (count - 1.0) / count);
}

void add_errors(Mixing& result, const std::vector<Sums>& cells, const Sums& all,
                double squares_of_means, const IndexSettings& settings) {
  if (cells.size() < 3) {
    for (double* error : {&result.lacey_error, &result.neighbour_index_error,
                          &result.intensity_error, &result.relative_deviation_error})
      *error = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  std::vector<Indices> left_out;
  for (const Sums& cell : cells)
    left_out.push_back(indices_of(all.without(cell), static_cast<double>(cells.size()) - 1.0,
                                  squares_of_means - mean_square(cell), settings));
  result.lacey_error = jackknife_error(left_out, &Indices::lacey);
  result.neighbour_index_error = jackknife_error(left_out, &Indices::neighbours);
  result.intensity_error = jackknife_error(left_out, &Indices::intensity);
  result.relative_deviation_error = jackknife_error(left_out, &Indices::relative_deviation);
}

/// The mean position of q along one axis over that of all, and its bounds (Siraj et al. 2011).
struct AxisIndex {
  double index = 1.0, lowest = 1.0, highest = 1.0, error = 0.0;
};

/// The largest sum of w q x / sum of w x over all orders of the particles at these coordinates: for
/// a given quotient L the best order has w (q - L) ascending with x (Dinkelbach 1967).
double largest_quotient(const std::vector<double>& sorted_places, const std::vector<double>& values,
                        const std::vector<double>& weights) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  double quotient = *std::min_element(values.begin(), values.end());
  constexpr int most_steps = 100; // it converges quadratically
  for (int step = 0; step < most_steps; ++step) {
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return weights[i] * (values[i] - quotient) < weights[j] * (values[j] - quotient);
    });
    double above = 0.0, below = 0.0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      above += weights[order[k]] * values[order[k]] * sorted_places[k];
      below += weights[order[k]] * sorted_places[k];
    }
    const double better = above / below;
    if (!(better > quotient * (1.0 + 1.0e-14)))
      return std::max(better, quotient);
    quotient = better;
  }
  return quotient;
}

AxisIndex axis_index(std::vector<double> coordinates, const std::vector<double>& values,
                     const std::vector<double>& weights) {
  const double count = static_cast<double>(coordinates.size());
  const double first = *std::min_element(coordinates.begin(), coordinates.end());
  double weight = 0.0, total = 0.0, mean = 0.0, weighted = 0.0, weighted_mean = 0.0, squares = 0.0;
  for (double& x : coordinates)
    x -= first;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    weight += weights[i];
    total += weights[i] * values[i];
    mean += coordinates[i] / count;
    weighted_mean += weights[i] * coordinates[i];
    weighted += weights[i] * values[i] * coordinates[i];
    squares += coordinates[i] * coordinates[i] / count;
  }
  if (!(mean > 0.0)) // all in one plane across this axis
    return {};
  const double p = total / weight;
  double spread = 0.0;
  std::vector<double> mirrored; // its largest quotient is the smallest one of q
  const double largest = *std::max_element(values.begin(), values.end());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double part = weights[i] * (values[i] - p);
    spread += part * part;
    mirrored.push_back(largest - values[i]);
  }
  AxisIndex result;
  result.index = weighted / weighted_mean / p;
  // of a mean over a random order (finite population)
  result.error = std::sqrt(spread * (squares - mean * mean) * count / (count - 1.0)) / total / mean;
  std::sort(coordinates.begin(), coordinates.end());
  result.highest = largest_quotient(coordinates, values, weights) / p;
  result.lowest = (largest - largest_quotient(coordinates, mirrored, weights)) / p;
  return result;
}

void add_mean_positions(Mixing& result, const ParticleSet& set, const std::vector<double>& values,
                        const std::vector<double>& weights) {
  std::array<std::vector<double>, 3> coordinates;
  for (const Particle& p : set.particles) {
    coordinates[0].push_back(p.centre.x);
    coordinates[1].push_back(p.centre.y);
    coordinates[2].push_back(p.centre.z);
  }
  double squared_error = 0.0;
  double* const each[3] = {&result.mean_position_x, &result.mean_position_y,
                           &result.mean_position_z};
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisIndex axis = axis_index(coordinates[k], values, weights);
    *each[k] = axis.index;
    result.mean_position += axis.index / 3.0;
    result.mean_position_lowest += axis.lowest / 3.0;
    result.mean_position_highest += axis.highest / 3.0;
    squared_error += axis.error * axis.error / 9.0;
  }
  result.mean_position_error = std::sqrt(squared_error);
}

void check(const std::vector<double>& values) {
  if (values.size() < 2)
    throw InputError("a mixture needs at least two particles");
  const auto range = std::minmax_element(values.begin(), values.end());
  if (!(*range.first >= 0.0))
    throw InputError(fmt::format("expected values >= 0 to be mixed, found {}", *range.first));
  constexpr double rounding = 1e-9; // of sizes and ratios that were computed
  if (!(*range.first < (1.0 - rounding) * *range.second))
    throw InputError("all particles are alike in what is to be mixed");
}

/// Of the cells that are not empty, in a fixed order.
struct CellSums {
  Sums all;
  std::vector<Sums> each;
  std::vector<std::size_t> cell_of; ///< by particle, in `each`
  double squares_of_means = 0.0;

  double count() const { return static_cast<double>(each.size()); }
};

CellSums sums_in_cells(const std::vector<Vector3>& centres, const std::vector<double>& values,
                       const std::vector<double>& weights,
                       const std::vector<std::vector<std::size_t>>& near, const Cells& cells) {
  using Key = std::array<std::int64_t, 3>;
  CellSums sums;
  std::map<Key, Sums> sums_of_cell;
  std::vector<Key> keys;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    double unlike = 0.0;
    for (const std::size_t k : near[i])
      unlike += weights[i] * weights[k] * (values[i] - values[k]) * (values[i] - values[k]);
    keys.push_back(cells.of(centres[i]));
    for (Sums* part : {&sums_of_cell[keys.back()], &sums.all})
      part->add(weights[i], values[i], unlike);
  }
  std::map<Key, std::size_t> number_of;
  for (const auto& [key, part] : sums_of_cell) {
    number_of.emplace(key, sums.each.size());
    sums.each.push_back(part);
    sums.squares_of_means += mean_square(part);
  }
  for (const Key& key : keys)
    sums.cell_of.push_back(number_of.at(key));
  if (sums.each.size() < 2)
    throw InputError("all particles lie in one cell: choose a smaller --cell");
  if (sums.each.size() == centres.size())
    throw InputError("every particle has a cell of its own: choose a larger --cell");
  return sums;
}

/// Adds what follows from the sums of the cells.
void add_indices(Mixing& result, const CellSums& sums, const IndexSettings& settings) {
  const Indices i = indices_of(sums.all, sums.count(), sums.squares_of_means, settings);
  result.cells = sums.each.size();
  result.mean = sums.all.values / sums.all.weight;
  result.variance = i.variance;
  result.variance_segregated = i.segregated;
  result.variance_random = i.random;
  result.lacey = i.lacey;
  result.neighbour_index = i.neighbours;
  result.intensity = i.intensity;
  result.intensity_random = i.random / i.segregated;
  result.relative_deviation = i.relative_deviation;
  result.relative_deviation_random = std::sqrt(i.random) / result.mean;
  result.relative_deviation_segregated = std::sqrt(i.segregated) / result.mean;
  add_errors(result, sums.each, sums.all, sums.squares_of_means, settings);
}

} // namespace

Mixing mixing(const ParticleSet& set, const std::vector<double>& values, const PeriodicCell& cell,
              const MixingOptions& options) {
  check(values);
  std::vector<Vector3> centres;
  for (const Particle& p : set.particles)
    centres.push_back(p.centre);
  const std::vector<double> weights =
      options.weights.empty() ? std::vector<double>(centres.size(), 1.0) : options.weights;
  const CellSums sums =
      sums_in_cells(centres, values, weights, nearest_neighbours(centres, cell, options.neighbours),
                    Cells(cell, options.cell_size));
  IndexSettings settings{static_cast<double>(options.neighbours), 1.0};
  if (!options.weights.empty()) {
    const double first_order =
        indices_of(sums.all, sums.count(), sums.squares_of_means, settings).random;
    settings.correction =
        random_variance(sums.cell_of, sums.each.size(), values, weights) / first_order;
  }
  Mixing result;
  result.particles = centres.size();
  add_indices(result, sums, settings);
  add_mean_positions(result, set, values, weights);
  return result;
}

} // namespace ellipsoid::post
