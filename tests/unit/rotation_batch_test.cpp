// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Bodies turned in batches against bodies turned one by one: the same bits.
#include "motion/rotation_batch.h"

#include "free_turn.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace ellipsoid;

TEST(RotationBatch, GivesTheBitsOfSingleBodies) {
  std::mt19937_64 random(20200);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> positive(0.1, 2.0);
  const double time_step = 0.05;
  for (const int count : {1, 7, 16, RotationBatch::capacity}) {
    RotationBatch batch;
    std::vector<Quaternion> orientations;
    std::vector<Vector3> momenta, inertias;
    for (int k = 0; k < count; ++k) {
      orientations.push_back(
          normalized(Quaternion{gauss(random), gauss(random), gauss(random), gauss(random)}));
      momenta.push_back({gauss(random), gauss(random), gauss(random)});
      inertias.push_back({positive(random), positive(random), positive(random)});
      batch.add(orientations.back(), momenta.back(), inverse(inertias.back()));
    }
    batch.solve(time_step);
    for (int k = 0; k < count; ++k) {
      const auto index = static_cast<std::size_t>(k);
      const auto [q, omega] =
          rotate_freely(orientations[index], momenta[index], inverse(inertias[index]), time_step);
      const Quaternion p = batch.orientation(k);
      const Vector3 w = batch.omega(k);
      EXPECT_EQ(p.w, q.w);
      EXPECT_EQ(p.x, q.x);
      EXPECT_EQ(p.y, q.y);
      EXPECT_EQ(p.z, q.z);
      EXPECT_EQ(w.x, omega.x);
      EXPECT_EQ(w.y, omega.y);
      EXPECT_EQ(w.z, omega.z);
    }
  }
}
