// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "mixing.h"

#include "nearest_neighbours.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace ellipsoid::post {
namespace {

/// Sums over the particles of a cell, or of all.
struct Sums {
  double count = 0.0, values = 0.0, squares = 0.0;
  double unlike = 0.0; ///< sum of (q_i - q_k)^2 over the neighbours k of its particles

  Sums without(const Sums& other) const {
    return {count - other.count, values - other.values, squares - other.squares,
            unlike - other.unlike};
  }
};

/// Which cell a point lies in: cells are equal shares of a repeating edge, else of this size from
/// the box's corner.
class Cells {
 public:
  Cells(const PeriodicCell& cell, double size) : m_cell(cell) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double parts = cell.thickness(k) / size;
      m_parts[k] = cell.is_periodic(k) ? std::max(1.0, std::round(parts)) : parts;
    }
  }
  std::array<std::int64_t, 3> of(const Vector3& point) const {
    const Vector3 f = m_cell.fractions(m_cell.wrapped(point));
    return {number(f.x * m_parts[0]), number(f.y * m_parts[1]), number(f.z * m_parts[2])};
  }

 private:
  static std::int64_t number(double x) { return static_cast<std::int64_t>(std::floor(x)); }
  const PeriodicCell& m_cell;
  std::array<double, 3> m_parts{};
};

/// The variances and the indices made of them, from sums over cells.
struct Indices {
  double variance = 0.0, segregated = 0.0, random = 0.0, lacey = 0.0, neighbours = 0.0;
};

/// @param[in] squares_of_means sum over the cells of (sum of q)^2 / count
Indices indices_of(const Sums& all, double cells, double squares_of_means, double per_particle) {
  Indices result;
  const double mean = all.values / all.count;
  result.variance = squares_of_means / all.count - mean * mean;
  result.segregated = all.squares / all.count - mean * mean;
  // mean of S^2 over all orders of the particles: sampling without replacement
  result.random = result.segregated * (cells - 1.0) / (all.count - 1.0);
  result.lacey =
      (result.segregated - result.variance) / (result.segregated - result.random); // Lacey 1954
  const double expected = 2.0 * result.segregated * all.count / (all.count - 1.0);
  result.neighbours = all.unlike / (all.count * per_particle) / expected;
  return result;
}

double mean_square(const Sums& cell) { return cell.values * cell.values / cell.count; }

/// Standard errors by leaving out one cell after the other (jackknife).
void add_errors(Mixing& result, const std::vector<Sums>& cells, const Sums& all,
                double squares_of_means, double per_particle) {
  const double count = static_cast<double>(cells.size());
  if (cells.size() < 3)
    return;
  std::vector<Indices> left_out;
  double lacey = 0.0, neighbours = 0.0;
  for (const Sums& cell : cells) {
    left_out.push_back(indices_of(all.without(cell), count - 1.0,
                                  squares_of_means - mean_square(cell), per_particle));
    lacey += left_out.back().lacey / count;
    neighbours += left_out.back().neighbours / count;
  }
  double lacey_squares = 0.0, neighbour_squares = 0.0;
  for (const Indices& i : left_out) {
    lacey_squares += (i.lacey - lacey) * (i.lacey - lacey);
    neighbour_squares += (i.neighbours - neighbours) * (i.neighbours - neighbours);
  }
  result.lacey_error = std::sqrt(lacey_squares * (count - 1.0) / count);
  result.neighbour_index_error = std::sqrt(neighbour_squares * (count - 1.0) / count);
}

/// The mean position of q along one axis over that of all, and its bounds (Siraj et al. 2011).
struct AxisIndex {
  double index = 1.0, lowest = 1.0, highest = 1.0, error = 0.0;
};

AxisIndex axis_index(std::vector<double> places, const std::vector<double>& values) {
  const double count = static_cast<double>(places.size());
  const double first = *std::min_element(places.begin(), places.end());
  double total = 0.0, mean = 0.0, weighted = 0.0, squares = 0.0;
  for (double& x : places)
    x -= first;
  for (std::size_t i = 0; i < places.size(); ++i) {
    total += values[i];
    mean += places[i] / count;
    weighted += values[i] * places[i];
    squares += places[i] * places[i] / count;
  }
  if (!(mean > 0.0)) // all in one plane across this axis
    return {};
  double spread = 0.0;
  for (const double q : values)
    spread += (q - total / count) * (q - total / count);
  AxisIndex result;
  result.index = weighted / total / mean;
  // of a mean over a random order (finite population)
  result.error = std::sqrt(spread * (squares - mean * mean) * count / (count - 1.0)) / total / mean;
  std::vector<double> sorted = values;
  std::sort(places.begin(), places.end());
  std::sort(sorted.begin(), sorted.end());
  double together = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    together += sorted[i] * places[i];
    apart += sorted[sorted.size() - 1 - i] * places[i];
  }
  result.highest = together / total / mean;
  result.lowest = apart / total / mean;
  return result;
}

void add_mean_positions(Mixing& result, const ParticleSet& set, const std::vector<double>& values) {
  std::array<std::vector<double>, 3> places;
  for (const Particle& p : set.particles) {
    places[0].push_back(p.centre.x);
    places[1].push_back(p.centre.y);
    places[2].push_back(p.centre.z);
  }
  double squared_error = 0.0;
  double* const each[3] = {&result.mean_position_x, &result.mean_position_y,
                           &result.mean_position_z};
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisIndex axis = axis_index(places[k], values);
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
  if (!(*range.first < *range.second))
    throw InputError("all particles are alike in what is to be mixed");
}

} // namespace

Mixing mixing(const ParticleSet& set, const std::vector<double>& values, const PeriodicCell& cell,
              const MixingOptions& options) {
  check(values);
  std::vector<Vector3> centres;
  for (const Particle& p : set.particles)
    centres.push_back(p.centre);
  const auto near = nearest_neighbours(centres, cell, options.neighbours);
  const Cells cells(cell, options.cell_size);
  std::map<std::array<std::int64_t, 3>, Sums> sums_of_cell;
  Sums all;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    double unlike = 0.0;
    for (const std::size_t k : near[i])
      unlike += (values[i] - values[k]) * (values[i] - values[k]);
    for (Sums* sums : {&sums_of_cell[cells.of(centres[i])], &all}) {
      sums->count += 1.0;
      sums->values += values[i];
      sums->squares += values[i] * values[i];
      sums->unlike += unlike;
    }
  }
  std::vector<Sums> each;
  double squares_of_means = 0.0;
  for (const auto& entry : sums_of_cell) {
    each.push_back(entry.second);
    squares_of_means += mean_square(entry.second);
  }
  if (each.size() < 2)
    throw InputError("all particles lie in one cell: choose a smaller --cell");
  if (each.size() == centres.size())
    throw InputError("every particle has a cell of its own: choose a larger --cell");
  const double per_particle = static_cast<double>(options.neighbours);
  const Indices i =
      indices_of(all, static_cast<double>(each.size()), squares_of_means, per_particle);
  Mixing result;
  result.particles = centres.size();
  result.cells = each.size();
  result.mean = all.values / all.count;
  result.variance = i.variance;
  result.variance_segregated = i.segregated;
  result.variance_random = i.random;
  result.lacey = i.lacey;
  result.neighbour_index = i.neighbours;
  result.intensity = i.variance / i.segregated; // Danckwerts 1952
  result.intensity_random = i.random / i.segregated;
  result.relative_deviation = std::sqrt(std::max(0.0, i.variance)) / result.mean;
  result.relative_deviation_random = std::sqrt(i.random) / result.mean;
  result.relative_deviation_segregated = std::sqrt(i.segregated) / result.mean;
  add_errors(result, each, all, squares_of_means, per_particle);
  add_mean_positions(result, set, values);
  return result;
}

} // namespace ellipsoid::post
