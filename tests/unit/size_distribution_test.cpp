// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Random factors of the semi-axes: bounds, moments and distribution functions.
#include "insertion/counter_random.h"
#include "insertion/size_distribution.h"

#include <gtest/gtest.h>

using namespace ellipsoid;
using Kind = SizeDistribution::Kind;

namespace {

const SizeDistribution all_kinds[] = {{Kind::constant, 0.7, 0.0},   {Kind::uniform, 0.05, 1.0},
                                      {Kind::uniform, 0.8, 0.8},    {Kind::gaussian, 1.0, 0.3},
                                      {Kind::lognormal, -0.2, 0.5}, {Kind::lognormal, 0.0, 0.0}};

double standard_normal(double z) { return 0.5 * std::erfc(-z * std::sqrt(0.5)); }

} // namespace

TEST(SizeDistribution, MomentsAreMeansOverTheUniformVariable) {
  constexpr int points = 20000; // midpoint rule of the inverse distribution function
  for (const SizeDistribution& d : all_kinds) {
    double sums[4] = {0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i < points; ++i) {
      const double value = d.draw((i + 0.5) / points);
      double power = 1.0;
      for (double& sum : sums) {
        sum += power / points;
        power *= value;
      }
    }
    for (int k = 0; k <= 3; ++k)
      EXPECT_NEAR(sums[k] / d.moment(k), 1.0, 1e-5) << "power " << k;
  }
}

TEST(SizeDistribution, BoundsAreReachedAndKept) {
  for (const SizeDistribution& d : all_kinds) {
    EXPECT_NEAR(d.draw(0.0), d.smallest(), 1e-9 * d.smallest());
    EXPECT_NEAR(d.draw(1.0 - 1e-16), d.largest(), 1e-9 * d.largest());
    CounterRandom random(5, 0);
    for (int i = 0; i < 10000; ++i) {
      const double value = d.draw(random.uniform());
      EXPECT_GE(value, d.smallest());
      EXPECT_LE(value, d.largest());
    }
  }
}

TEST(SizeDistribution, DrawInvertsTheDistributionFunction) {
  const SizeDistribution normal(Kind::gaussian, 2.0, 0.5), log(Kind::lognormal, 0.3, 0.4);
  const double outside = standard_normal(-3.0);
  for (double u = 0.001; u < 1.0; u += 0.0137) {
    const double share = outside + u * (1.0 - 2.0 * outside);
    EXPECT_NEAR(standard_normal((normal.draw(u) - 2.0) / 0.5), share, 1e-14);
    EXPECT_NEAR(standard_normal((std::log(log.draw(u)) - 0.3) / 0.4), share, 1e-14);
  }
}
