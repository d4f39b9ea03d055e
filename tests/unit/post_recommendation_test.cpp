// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which number of sub-spheres is recommended: by hand from made-up piles, and what is said without
// piles.
#include "multisphere/multisphere_template.h"
#include "recommendation.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace ellipsoid::post {
namespace {

using Differences = std::vector<study::Difference>;

int recommended(const Differences& differences, double tolerance) {
  return advice_of_runs("angle of repose", differences, tolerance).subspheres;
}

TEST(Recommendation, IsTheSmallestNFromWhichOnAllLieWithinTheTolerance) {
  const Differences piles = {{3, 5, 15, 20.0, 16.0, 24.0},
                             {5, 5, 15, 4.0, 1.0, 7.0},
                             {9, 5, 15, 8.0, 6.0, 9.5},
                             {13, 5, 15, 1.0, -1.5, 4.5},
                             {17, 5, 15, 0.5, -1.0, 1.9}};
  EXPECT_EQ(recommended(piles, 0.02), 17);
  EXPECT_EQ(recommended(piles, 0.05), 13); // 9 is outside again
  EXPECT_EQ(recommended(piles, 0.10), 5);
  EXPECT_EQ(recommended(piles, 0.25), 3);
  EXPECT_EQ(recommended(piles, 0.01), 0);
}

TEST(Recommendation, SaysWhyThereIsNone) {
  const auto source = [](const Differences& piles) {
    return advice_of_runs("porosity", piles, 0.05).source;
  };
  EXPECT_NE(
      source({{17, 1, 2, 1.0, -20.0, 22.0}}).find("undecided: N = 17: +1.0 % (-20.0 to +22.0"),
      std::string::npos);
  EXPECT_NE(source({{17, 5, 9, 8.0, 6.0, 10.0}}).find("not reached"), std::string::npos);
  EXPECT_NE(source({{17, 5, 9, -8.0, -10.0, -6.0}}).find("not reached"), std::string::npos);
  EXPECT_EQ(source({}), "no piles are kept");
}

TEST(Recommendation, OfGeometryIsTheSmallestNWithinTheTolerance) {
  for (const double aspect : {1.5, 2.35, 5.0})
    for (const Advice& advice : recommend(aspect, {0.02, 0.1})) {
      if (advice.quantity != "area")
        continue;
      const auto error = [&](int count) {
        return measure(make_multisphere(aspect, 1.0, count)).area_shape_factor;
      };
      EXPECT_LE(error(advice.subspheres), advice.tolerance);
      try {
        EXPECT_GT(error(advice.subspheres - 2), advice.tolerance);
      } catch (const std::invalid_argument&) { // the coarser chain cannot be built
      }
    }
}

TEST(Recommendation, SaysThatOtherAspectRatiosWereNotRun) {
  const auto others = recommend(5.0, {0.05});
  EXPECT_EQ(std::count_if(others.begin(), others.end(),
                          [](const Advice& advice) {
                            return advice.subspheres == 0 &&
                                   advice.source.find("no piles were run") != std::string::npos;
                          }),
            3);
}

} // namespace
} // namespace ellipsoid::post
