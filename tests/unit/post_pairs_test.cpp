// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Pairs: ideal gas, face-centred cubic lattice, gaps of bodies by brute force.
#include "pair_distributions.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace ellipsoid::post {
namespace {

const std::array<Vector3, 3> edges{Vector3{3.0, 0.0, 0.0}, Vector3{0.8, 2.5, 0.0},
                                   Vector3{-0.6, 0.4, 2.8}};

ParticleSet gas(const PeriodicCell& cell, int count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::normal_distribution<double> normal;
  ParticleSet set;
  for (int n = 0; n < count; ++n) {
    Particle p;
    p.centre = cell.corner() + share(generator) * cell.edge(0) + share(generator) * cell.edge(1) +
               share(generator) * cell.edge(2);
    p.semiaxes = {0.1, 0.2, 0.1};
    p.orientation = normalized(
        Quaternion{normal(generator), normal(generator), normal(generator), normal(generator)});
    set.particles.push_back(p);
  }
  return set;
}

TEST(Pairs, an_ideal_gas_has_one_everywhere) {
  const std::array<Vector3, 3> straight{Vector3{3.0, 0.0, 0.0}, Vector3{0.0, 2.5, 0.0},
                                        Vector3{0.0, 0.0, 2.8}};
  const PeriodicCell cells[] = {PeriodicCell({1.0, 2.0, 3.0}, edges, {true, true, true}),
                                PeriodicCell({}, straight, {false, false, false}),
                                PeriodicCell({}, straight, {true, false, true}),
                                PeriodicCell({}, straight, {false, true, false})};
  for (const PeriodicCell& cell : cells) {
    const ParticleSet set = gas(cell, 3000, 7);
    for (const DistanceBin& bin : pair_distribution(set, cell, 1.1, 10)) {
      const double volume =
          4.0 / 3.0 * 3.14159265 * (std::pow(bin.end, 3) - std::pow(bin.begin, 3));
      const double pairs = 0.5 * 3000.0 * 3000.0 * volume / cell.volume();
      // scatter of the number of pairs; the extent of the centres is short of the box by 1e-3
      EXPECT_NEAR(bin.g, 1.0, 5.0 / std::sqrt(0.5 * pairs) + 2e-3) << bin.begin;
      if (pairs > 1000.0) {
        EXPECT_NEAR(*bin.g2, 0.0, 5.0 * 0.45 / std::sqrt(0.5 * pairs));
      }
    }
  }
  EXPECT_THROW(pair_distribution(gas(cells[0], 10, 1), cells[0], 2.0, 10), InputError);
}

/// Face-centred cubic: 4 x 4 x 4 cubes of edge 1.
ParticleSet fcc() {
  ParticleSet set;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      for (int k = 0; k < 8; ++k)
        if ((i + j + k) % 2 == 0) {
          Particle p;
          p.centre = {0.5 * i, 0.5 * j, 0.5 * k};
          p.semiaxes = {0.3, 0.3, 0.3};
          set.particles.push_back(p);
        }
  return set;
}

const PeriodicCell cube({},
                        {Vector3{4.0, 0.0, 0.0}, Vector3{0.0, 4.0, 0.0}, Vector3{0.0, 0.0, 4.0}},
                        {true, true, true});

TEST(Pairs, a_lattice_has_its_shells) {
  const ParticleSet set = fcc();
  const double n = static_cast<double>(set.particles.size());
  std::vector<double> neighbours; // per particle and bin
  for (const DistanceBin& bin : pair_distribution(set, cube, 1.3, 130)) {
    const double shell =
        4.0 / 3.0 * 3.14159265358979 * (std::pow(bin.end, 3) - std::pow(bin.begin, 3));
    neighbours.push_back(bin.g * (n - 1.0) * shell / 64.0);
    EXPECT_FALSE(bin.g2); // spheres have no direction
  }
  EXPECT_NEAR(neighbours[70], 12.0, 1e-9);                  // sqrt(1/2)
  EXPECT_NEAR(neighbours[99] + neighbours[100], 6.0, 1e-9); // 1
  EXPECT_NEAR(neighbours[122], 24.0, 1e-9);                 // sqrt(3/2)
  double all = 0.0;
  for (const double count : neighbours)
    all += count;
  EXPECT_NEAR(all, 42.0, 1e-9);
}

TEST(Pairs, gaps_of_a_lattice) {
  const auto gaps = gap_distribution(fcc(), cube, -0.015, 0.405, 42);
  // nearest surfaces are sqrt(1/2) - 0.6 = 0.107 apart, the next ones 0.4
  for (const GapBin& bin : gaps)
    EXPECT_EQ(bin.neighbours, bin.end < 0.1071 ? 0.0 : bin.end < 0.404 ? 12.0 : 18.0) << bin.end;
  EXPECT_NEAR(gaps[12].density, 12.0 / 0.01, 1e-6);
}

/// Points of a body's surface on a grid of angles.
std::vector<Vector3> surface(const ParticleSet& set, const Particle& p) {
  std::vector<Vector3> points;
  constexpr int n = 120;
  for (int a = 0; a <= n; ++a)
    for (int b = 0; b < 2 * n; ++b) {
      const double theta = M_PI * a / n, phi = M_PI * b / n;
      const Vector3 u{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                      std::cos(theta)};
      if (p.is_smooth())
        points.push_back(
            p.centre + rotation(p.orientation)
                           .to_space({p.semiaxes.x * u.x, p.semiaxes.y * u.y, p.semiaxes.z * u.z}));
      for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k)
        points.push_back(set.spheres[k].centre + set.spheres[k].radius * u);
    }
  return points;
}

TEST(Pairs, gaps_between_bodies_are_the_shortest_ways) {
  const PeriodicCell cell({}, edges, {true, true, true});
  ParticleSet set = gas(cell, 2, 31);
  set.particles[0].centre = {0.0, 0.0, 0.0};
  set.particles[1].centre = {0.35, 0.3, 0.1};
  Particle chain;
  chain.centre = {0.1, -0.5, 0.2};
  chain.semiaxes = {0.2, 0.1, 0.1};
  chain.sphere_count = 2;
  set.spheres = {{{0.0, -0.5, 0.2}, 0.1}, {{0.15, -0.5, 0.25}, 0.12}};
  set.particles.push_back(chain);
  Particle other = chain;
  other.centre = {0.1, -0.5, 0.8};
  other.first_sphere = 2;
  for (std::size_t k = 0; k < 2; ++k)
    set.spheres.push_back({set.spheres[k].centre + Vector3{0.0, 0.0, 0.6}, set.spheres[k].radius});
  set.particles.push_back(other);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      double shortest = 1e9;
      const auto q_points = surface(set, set.particles[j]);
      const auto p_points = surface(set, set.particles[i]);
      for (std::size_t a = 0; a < p_points.size(); a += 7)
        for (std::size_t b = 0; b < q_points.size(); b += 11)
          shortest = std::min(shortest, norm(p_points[a] - q_points[b]));
      EXPECT_NEAR(surface_gap(set, i, j, {}), shortest, 0.02) << i << j;
      EXPECT_LE(surface_gap(set, i, j, {}), shortest + 1e-9) << i << j;
      EXPECT_NEAR(surface_gap(set, i, j, {}), surface_gap(set, j, i, {}), 1e-9);
    }
}

TEST(Pairs, structure_of_a_lattice_and_a_gas) {
  const ParticleSet set = fcc();
  // Bragg peak of the planes (111): k = 2 pi sqrt(3), below it nothing
  const auto bins = structure_factor(set, cube, 11.5, 115);
  for (const StructureBin& bin : bins)
    if (bin.vectors > 0 && bin.wave_number < 10.8) {
      EXPECT_NEAR(bin.s, 0.0, 1e-9);
    }
  const double peak = 2.0 * M_PI * std::sqrt(3.0);
  double found = 0.0;
  for (const StructureBin& bin : bins)
    if (std::abs(bin.wave_number - peak) < 0.1)
      found += bin.s * static_cast<double>(bin.vectors);
  EXPECT_NEAR(found, 8.0 * static_cast<double>(set.particles.size()), 1e-6);
  const PeriodicCell cell({}, edges, {true, true, true});
  double mean = 0.0, vectors = 0.0;
  for (const StructureBin& bin : structure_factor(gas(cell, 500, 5), cell, 20.0, 10)) {
    mean += bin.s * static_cast<double>(bin.vectors);
    vectors += static_cast<double>(bin.vectors);
  }
  EXPECT_NEAR(mean / vectors, 1.0, 5.0 * std::sqrt(2.0 / vectors)); // k and -k are the same
}

} // namespace
} // namespace ellipsoid::post
