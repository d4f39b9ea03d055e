// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Neighbours against brute force; indices of mixing against random and made arrays.
#include "mixing.h"
#include "nearest_neighbours.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace ellipsoid::post {
namespace {

const PeriodicCell tilted({0.1, 0.2, 0.3},
                          {Vector3{3.0, 0.0, 0.0}, Vector3{1.1, 2.0, 0.0}, Vector3{-0.5, 0.7, 2.5}},
                          {true, true, true});

TEST(NearestNeighbours, are_those_of_brute_force) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> any(-5.0, 5.0);
  std::vector<Vector3> points;
  for (int n = 0; n < 60; ++n)
    points.push_back({any(generator), any(generator), any(generator)});
  for (const PeriodicCell& cell : {tilted, PeriodicCell()}) {
    const auto near = nearest_neighbours(points, cell, 6);
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::vector<double> squares;
      for (std::size_t j = 0; j < points.size(); ++j)
        if (j != i)
          for (int a = -8; a <= 8; ++a)
            for (int b = -8; b <= 8; ++b)
              for (int c = -8; c <= 8; ++c) {
                if (!cell.is_periodic() && (a != 0 || b != 0 || c != 0))
                  continue;
                const Vector3 d = points[j] + double(a) * cell.edge(0) + double(b) * cell.edge(1) +
                                  double(c) * cell.edge(2) - points[i];
                squares.push_back(dot(d, d));
              }
      std::nth_element(squares.begin(), squares.begin() + 5, squares.end());
      const Vector3 last = cell.nearest(points[near[i].back()] - points[i]);
      ASSERT_EQ(near[i].size(), 6u);
      if (!cell.is_periodic())
        EXPECT_NEAR(dot(last, last), squares[5], 1e-12);
      else // its nearest image is not farther than the one that was found
        EXPECT_LE(dot(last, last), squares[5] + 1e-12);
    }
  }
  EXPECT_THROW(nearest_neighbours(points, tilted, 60), InputError);
}

/// A lattice of small balls, 16 in every direction of a unit box.
ParticleSet lattice() {
  ParticleSet set;
  constexpr int n = 16;
  for (int k = 0; k < n * n * n; ++k) {
    Particle p;
    p.semiaxes = {0.02, 0.02, 0.02};
    p.centre = {(k % n + 0.5) / n, (k / n % n + 0.5) / n, (k / n / n + 0.5) / n};
    set.particles.push_back(p);
  }
  return set;
}

const PeriodicCell
    unit_box({}, {Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0}, Vector3{0.0, 0.0, 1.0}},
             {true, true, true});

TEST(Mixing, random_orders_have_the_random_values) {
  const ParticleSet set = lattice();
  std::mt19937 generator(8);
  std::vector<double> values(set.particles.size(), 0.0);
  std::fill(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4), 1.0);
  MixingOptions options;
  options.cell_size = 0.25;
  double lacey = 0.0, lacey_squares = 0.0, neighbours = 0.0, position = 0.0, variance = 0.0;
  double lacey_error = 0.0, position_squares = 0.0, position_error = 0.0, random = 0.0;
  constexpr int trials = 60;
  for (int trial = 0; trial < trials; ++trial) {
    std::shuffle(values.begin(), values.end(), generator);
    const Mixing m = mixing(set, values, unit_box, options);
    EXPECT_EQ(m.cells, 64u);
    lacey += m.lacey / trials;
    lacey_squares += m.lacey * m.lacey / trials;
    lacey_error += m.lacey_error / trials;
    neighbours += m.neighbour_index / trials;
    position += m.mean_position / trials;
    position_squares += (m.mean_position - 1.0) * (m.mean_position - 1.0) / trials;
    position_error = m.mean_position_error;
    variance += m.variance / trials;
    random = m.variance_random;
  }
  // Lacey 1954: p (1 - p) / n, here without replacement: (C - 1) / (N - 1) for 64 / 4096
  EXPECT_NEAR(random, 0.25 * 0.75 * 63.0 / 4095.0, 1e-12);
  EXPECT_NEAR(variance / random, 1.0, 0.1); // 63 degrees of freedom, 60 trials: 0.023
  EXPECT_NEAR(lacey, 1.0, 1e-3);
  EXPECT_NEAR(neighbours, 1.0, 5e-3);
  EXPECT_NEAR(position, 1.0, 3.0 * position_error / std::sqrt(double(trials)));
  EXPECT_NEAR(std::sqrt(position_squares), position_error, 0.3 * position_error);
  const double spread = std::sqrt(lacey_squares - lacey * lacey);
  EXPECT_NEAR(lacey_error, spread, 0.3 * spread); // 60 trials: 0.09
}

TEST(Mixing, a_demixed_bed_has_the_segregated_values) {
  const ParticleSet set = lattice();
  std::vector<double> values;
  for (const Particle& p : set.particles)
    values.push_back(p.centre.z < 0.25 ? 1.0 : 0.0);
  MixingOptions options;
  options.cell_size = 0.25; // the border lies between cells
  options.neighbours = 6;
  const Mixing m = mixing(set, values, unit_box, options);
  EXPECT_NEAR(m.lacey, 0.0, 1e-12);
  EXPECT_NEAR(m.intensity, 1.0, 1e-12);
  EXPECT_NEAR(m.relative_deviation, std::sqrt(3.0), 1e-12); // sqrt((1 - p) / p), p = 1/4
  EXPECT_NEAR(m.relative_deviation_segregated, std::sqrt(3.0), 1e-12);
  // along z: mean of layers 0 to 3 over that of 0 to 15
  EXPECT_NEAR(m.mean_position_z, 1.5 / 7.5, 1e-12);
  EXPECT_NEAR(m.mean_position_x, 1.0, 1e-12);
  EXPECT_NEAR(m.mean_position_lowest, 1.5 / 7.5, 1e-12);
  EXPECT_NEAR(m.mean_position_highest, 13.5 / 7.5, 1e-12);
  // of 16 layers those on either side of the two borders have one unlike neighbour in six:
  // 4 / 16 / 6 over 2 p (1 - p) N / (N - 1)
  EXPECT_NEAR(m.neighbour_index, 4.0 / 96.0 / (2.0 * 0.1875 * 4096.0 / 4095.0), 1e-12);
}

TEST(Mixing, a_checkerboard_is_more_even_than_random) {
  const ParticleSet set = lattice();
  std::vector<double> values;
  for (std::size_t k = 0; k < set.particles.size(); ++k)
    values.push_back((k + k / 16 + k / 256) % 2 == 0 ? 1.0 : 0.0);
  MixingOptions options;
  options.cell_size = 0.25;
  options.neighbours = 6;
  const Mixing m = mixing(set, values, unit_box, options);
  EXPECT_NEAR(m.variance, 0.0, 1e-12);
  EXPECT_GT(m.lacey, 1.0);
  EXPECT_NEAR(m.neighbour_index, 2.0, 1e-3); // all neighbours are unlike
  EXPECT_THROW(mixing(set, std::vector<double>(values.size(), 1.0), unit_box, options), InputError);
  options.cell_size = 2.0;
  EXPECT_THROW(mixing(set, values, unit_box, options), InputError);
}

} // namespace
} // namespace ellipsoid::post
