// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Motions of surfaces against the surfaces themselves.
#include "multisphere/motion_batch.h"

#include "ellipsoid/ellipsoid_contact.h"
#include "multisphere/near_spheres.h"

#include "chain_motion.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace ellipsoid;

namespace {

/// How far the ellipsoid reaches along the direction, from its centre.
double reach(const double* axes, const double* q, const Vector3& direction) {
  const Rotation3 r = rotation({q[0], q[1], q[2], q[3]});
  return norm(Vector3{axes[0] * dot(r.column_x, direction), axes[1] * dot(r.column_y, direction),
                      axes[2] * dot(r.column_z, direction)});
}

} // namespace

TEST(MotionBatch, TurnsBoundWhatSurfacesDo) {
  std::mt19937_64 random(20100603);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> positive(0.1, 2.0);
  double tightest = 0.0;
  for (const int count : {1, 7, 63, Motions::capacity}) {
    std::vector<double> axes, radii, x, q, last_x, last_q;
    for (int k = 0; k < count; ++k) {
      const double change = k % 5 == 0 ? 1.0 : 1e-6 * k; // any turn; small ones
      const Quaternion before =
          normalized(Quaternion{gauss(random), gauss(random), gauss(random), gauss(random)});
      const Quaternion after = normalized(
          Quaternion{before.w + change * gauss(random), before.x + change * gauss(random),
                     before.y + change * gauss(random), before.z + change * gauss(random)});
      axes.insert(axes.end(), {positive(random), positive(random), positive(random)});
      radii.push_back(turning_radius(axes[axes.size() - 3], axes[axes.size() - 2], axes.back()));
      last_q.insert(last_q.end(), {before.w, before.x, before.y, before.z});
      q.insert(q.end(), {after.w, after.x, after.y, after.z});
      for (int l = 0; l < 3; ++l) {
        last_x.push_back(gauss(random));
        x.push_back(gauss(random));
      }
    }
    const std::vector<double> q_before = last_q, x_before = last_x;
    Motions motions;
    motions.count = count;
    measure_motions({radii.data(), x.data(), q.data(), last_x.data(), last_q.data()}, motions);
    EXPECT_EQ(last_x, x);
    EXPECT_EQ(last_q, q);
    for (int k = 0; k < count; ++k) {
      for (int l = 3 * k; l < 3 * k + 3; ++l)
        EXPECT_EQ(motions.displacements[l], x[l] - x_before[l]);
      for (int direction = 0; direction < 100; ++direction) {
        const Vector3 n = normalized(Vector3{gauss(random), gauss(random), gauss(random)});
        const double moved =
            std::fabs(reach(&axes[3 * k], &q[4 * k], n) - reach(&axes[3 * k], &q_before[4 * k], n));
        // to the rounding of the two reaches
        ASSERT_LE(moved, motions.turns[k] + 1e-14) << count << " particles, particle " << k;
        if (k % 5 != 0 && k > 0)
          tightest = std::max(tightest, moved / motions.turns[k]);
      }
    }
  }
  EXPECT_GT(tightest, 0.5); // not by much more than needed
}

TEST(MotionBatch, ChainsMoveAsOneByOne) {
  std::mt19937_64 random(20100603);
  std::normal_distribution<double> gauss;
  const MultisphereBody five(make_multisphere(2.35, 1.0, 5)), one(make_multisphere(1.5, 1.0, 1));
  for (const int count : {1, 7, 63, Motions::capacity}) {
    std::vector<double> axes, x, q, last_x;
    std::vector<MultispherePose> poses, after;
    for (int k = 0; k < count; ++k) {
      const Quaternion turned =
          normalized(Quaternion{gauss(random), gauss(random), gauss(random), gauss(random)});
      const double scale = k % 3 == 0 ? 1.2 : 1.0;
      axes.insert(axes.end(), {2.35 * scale, scale, scale});
      q.insert(q.end(), {turned.w, turned.x, turned.y, turned.z});
      for (int l = 0; l < 3; ++l) {
        last_x.push_back(gauss(random));
        x.push_back(gauss(random));
      }
      const MultisphereBody* chain = k % 2 == 0 ? &five : &one;
      const Vector3 axis = normalized(Vector3{gauss(random), gauss(random), gauss(random)});
      poses.push_back({chain, axis, 1.0});
      after.push_back({chain, rotation(turned).column_x, scale});
    }
    const std::vector<double> x_before = last_x;
    const std::vector<MultispherePose> before = poses;
    Motions motions;
    motions.count = count;
    measure_motions({axes.data(), x.data(), q.data(), last_x.data(), poses.data()}, motions);
    EXPECT_EQ(last_x, x);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      EXPECT_EQ(poses[k].body, after[k].body);
      EXPECT_EQ(poses[k].scale, after[k].scale);
      EXPECT_EQ(norm(poses[k].axis - after[k].axis), 0.0);
      for (std::size_t l = 3 * k; l < 3 * k + 3; ++l)
        EXPECT_EQ(motions.displacements[l], x[l] - x_before[l]);
      EXPECT_EQ(motions.turns[k], motion(before[k], after[k], {}).turn);
    }
  }
}
