// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Random numbers that depend on (seed, particle, draw) alone: reproducible, uniform, independent.
#include "insertion/counter_random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

using ellipsoid::CounterRandom;

namespace {

constexpr int many = 100000;

/// Chi-square of `values` in [0, 1) over `bins` equal bins.
double chi_square(const std::vector<double>& values, int bins) {
  std::vector<int> counts(static_cast<std::size_t>(bins));
  for (const double v : values)
    ++counts[static_cast<std::size_t>(v * bins)];
  const double expected = static_cast<double>(values.size()) / bins;
  double sum = 0.0;
  for (const int count : counts)
    sum += (count - expected) * (count - expected) / expected;
  return sum;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    sum += (a[k] - 0.5) * (b[k] - 0.5);
  return 12.0 * sum / static_cast<double>(a.size());
}

} // namespace

TEST(CounterRandom, SameSeedAndParticleSameNumbers) {
  CounterRandom first(7, 3), second(7, 3);
  for (int k = 0; k < 100; ++k)
    EXPECT_EQ(first.uniform(), second.uniform());
}

TEST(CounterRandom, AllSeedsAndParticlesDiffer) {
  std::set<double> seen;
  for (unsigned seed = 0; seed < 300; ++seed)
    for (unsigned particle = 0; particle < 300; ++particle)
      seen.insert(CounterRandom(seed, particle).uniform());
  EXPECT_EQ(seen.size(), 300U * 300U);
}

TEST(CounterRandom, WithinBounds) {
  CounterRandom random(1, 0);
  for (int k = 0; k < many; ++k) {
    const double value = random.uniform(-3.0, -2.5);
    EXPECT_GE(value, -3.0);
    EXPECT_LT(value, -2.5);
  }
  EXPECT_EQ(CounterRandom(1, 0).uniform(2.0, 2.0), 2.0);
}

TEST(CounterRandom, UniformOverDrawsAndOverParticlesAndOverSeeds) {
  std::vector<double> draws, particles, seeds;
  CounterRandom one(42, 5);
  for (unsigned k = 0; k < many; ++k) {
    draws.push_back(one.uniform());
    particles.push_back(CounterRandom(42, k).uniform());
    seeds.push_back(CounterRandom(k, 5).uniform());
  }
  // 99 degrees of freedom: mean 99, standard deviation 14
  for (const auto& values : {draws, particles, seeds}) {
    const double deviation = (chi_square(values, 100) - 99.0) / 14.07;
    EXPECT_LT(std::fabs(deviation), 4.0);
  }
}

TEST(CounterRandom, NeighboursAreIndependent) {
  std::vector<double> first, second, next_particle, next_seed;
  for (unsigned k = 0; k < many; ++k) {
    CounterRandom random(11, k);
    first.push_back(random.uniform());
    second.push_back(random.uniform());
    next_particle.push_back(CounterRandom(11, k + 1).uniform());
    next_seed.push_back(CounterRandom(12, k).uniform());
  }
  const double four_deviations = 4.0 / std::sqrt(static_cast<double>(many));
  EXPECT_LT(std::fabs(correlation(first, second)), four_deviations);
  EXPECT_LT(std::fabs(correlation(first, next_particle)), four_deviations);
  EXPECT_LT(std::fabs(correlation(first, next_seed)), four_deviations);
}
