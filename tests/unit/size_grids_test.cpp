// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Grids per size class against all pairs.
#include "neighbours/size_grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ellipsoid {
namespace {

struct Bodies {
  std::vector<double> centres, radii;
  std::mt19937_64 engine{5};
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  void add(double x, double y, double z, double radius) {
    centres.insert(centres.end(), {x, y, z});
    radii.push_back(radius);
  }
  std::vector<int> near(int i, const SizeGrids::Reach& reach) const {
    std::vector<int> found;
    for (int j = i + 1; j < static_cast<int>(radii.size()); ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const double way =
          std::hypot(centres[3 * a] - centres[3 * b], centres[3 * a + 1] - centres[3 * b + 1],
                     centres[3 * a + 2] - centres[3 * b + 2]);
      if (way <= reach.factor * (radii[a] + radii[b]) + reach.skin)
        found.push_back(j);
    }
    return found;
  }
};

void expect_all_pairs(const Bodies& bodies, const SizeGrids::Reach& reach) {
  SizeGrids grids;
  grids.build(bodies.centres.data(), bodies.radii.data(), bodies.radii.size(), reach);
  for (int i = 0; i < static_cast<int>(bodies.radii.size()); ++i) {
    std::vector<int> found = grids.find(i);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, bodies.near(i, reach)) << "body " << i;
  }
}

} // namespace

TEST(SizeGrids, FindAllPairs) {
  for (const double ratio : {1.0, 3.0, 20.0, 1e6})
    for (const double skin : {0.0, 0.05, 3.0})
      for (const double height : {0.0, 1.0, 10.0}) {
        Bodies bodies;
        for (int k = 0; k < 400; ++k)
          bodies.add(bodies.uniform(-5.0, 5.0), bodies.uniform(90.0, 100.0),
                     bodies.uniform(0.0, height), std::pow(ratio, -bodies.uniform(0.0, 1.0)));
        expect_all_pairs(bodies, {1.0, skin});
        expect_all_pairs(bodies, {1.1, skin});
      }
}

TEST(SizeGrids, FewBodiesFarApartNeedFewCells) {
  Bodies bodies;
  for (const double x : {0.0, 1e9, 1e9 + 1.5, 3e12})
    bodies.add(x, 0.5 * x, -x, x > 1.0 ? 1.0 : 1e-3);
  expect_all_pairs(bodies, {1.0, 1e-3});
  expect_all_pairs(Bodies(), {1.0, 0.0});
}

TEST(SizeGrids, PairsAtTheLimitAreFound) {
  Bodies bodies;
  bodies.add(0.0, 0.0, 0.0, 0.7);
  bodies.add(0.7 + 0.1 + 0.03, 0.0, 0.0, 0.1);
  bodies.add(0.0, -(0.7 + 0.1 + 0.03), 0.0, 0.1);
  SizeGrids grids;
  grids.build(bodies.centres.data(), bodies.radii.data(), 3, {1.0, 0.03});
  EXPECT_EQ(grids.find(0).size(), 2U);
}

TEST(SizeGrids, AreWorthwhileForManySizes) {
  const double radii[] = {1.0, 1.9, 0.96};
  EXPECT_FALSE(SizeGrids::are_worthwhile(radii, 3));
  const double many[] = {1.0, 2.0};
  EXPECT_TRUE(SizeGrids::are_worthwhile(many, 2));
  EXPECT_FALSE(SizeGrids::are_worthwhile(many, 0));
}

} // namespace ellipsoid
