// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Steps of many bodies in the plane against the formulas, body by body.
#include "motion/planar_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace ellipsoid;

namespace {

constexpr int moving = 2; // bit of the group

/// Bodies of which every third stays.
struct Bodies {
  std::vector<double> x, v, f, omega, momentum, torque, q, mass, inverse_inertia;
  std::vector<int> groups;

  Bodies(int count, double spin) {
    std::mt19937_64 random(20100607);
    std::normal_distribution<double> gauss;
    for (int k = 0; k < count; ++k) {
      for (std::vector<double>* rows : {&x, &v, &f, &omega, &momentum, &torque})
        for (int l = 0; l < 3; ++l)
          rows->push_back(gauss(random));
      const Quaternion any =
          normalized(Quaternion{gauss(random), gauss(random), gauss(random), gauss(random)});
      q.insert(q.end(), {any.w, any.x, any.y, any.z});
      mass.push_back(1.0 + std::fabs(gauss(random)));
      inverse_inertia.push_back(1.0 + std::fabs(gauss(random)));
      momentum.back() *= spin;
      groups.push_back(k % 3 == 2 ? 1 : 1 | moving);
    }
  }

  PlanarRows rows() {
    return {x.data(),      v.data(), f.data(),    omega.data(),           momentum.data(),
            torque.data(), q.data(), mass.data(), inverse_inertia.data(), groups.data(),
            moving};
  }
};

constexpr double time_step = 1e-3, half_step = 0.5e-3;

/// Velocity and spin after half a step, and nothing out of the plane.
void expect_kicked(const Bodies& before, const Bodies& after, std::size_t k) {
  for (std::size_t l = 3 * k; l < 3 * k + 2; ++l) {
    EXPECT_DOUBLE_EQ(after.v[l], before.v[l] + half_step * before.f[l] / before.mass[k]);
    EXPECT_EQ(after.omega[l], 0.0);
  }
  const std::size_t z = 3 * k + 2;
  EXPECT_EQ(after.v[z], 0.0);
  EXPECT_DOUBLE_EQ(after.momentum[z], before.momentum[z] + half_step * before.torque[z]);
  EXPECT_DOUBLE_EQ(after.omega[z], after.momentum[z] * before.inverse_inertia[k]);
}

void expect_same_row(const std::vector<double>& a, const std::vector<double>& b, std::size_t k,
                     std::size_t width) {
  for (std::size_t l = width * k; l < width * (k + 1); ++l)
    EXPECT_EQ(a[l], b[l]) << "body " << k;
}

void expect_untouched(const Bodies& before, const Bodies& after, std::size_t k) {
  expect_same_row(before.x, after.x, k, 3);
  expect_same_row(before.v, after.v, k, 3);
  expect_same_row(before.f, after.f, k, 3);
  expect_same_row(before.omega, after.omega, k, 3);
  expect_same_row(before.momentum, after.momentum, k, 3);
  expect_same_row(before.torque, after.torque, k, 3);
  expect_same_row(before.q, after.q, k, 4);
}

} // namespace

// With turns of some 1e-3 rad in a step, and of some rad: both formulas for the norm.
TEST(PlanarMotion, StartOfAStep) {
  for (const double spin : {1.0, 3000.0})
    for (const int count : {1, 2, 65}) {
      const Bodies before(count, spin);
      Bodies after = before;
      start_planar_step(after.rows(), count, time_step, half_step);
      for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        if (!(before.groups[k] & moving)) {
          expect_untouched(before, after, k);
          continue;
        }
        expect_kicked(before, after, k);
        for (std::size_t l = 3 * k; l < 3 * k + 2; ++l)
          EXPECT_DOUBLE_EQ(after.x[l], before.x[l] + time_step * after.v[l]);
        EXPECT_EQ(after.x[3 * k + 2], before.x[3 * k + 2]);
        const double* q = &before.q[4 * k];
        const Quaternion turned =
            normalized(Quaternion{1.0, 0.0, 0.0, 0.5 * time_step * after.omega[3 * k + 2]} *
                       Quaternion{q[0], q[1], q[2], q[3]});
        EXPECT_NEAR(after.q[4 * k], turned.w, 5e-16);
        EXPECT_NEAR(after.q[4 * k + 1], turned.x, 5e-16);
        EXPECT_NEAR(after.q[4 * k + 2], turned.y, 5e-16);
        EXPECT_NEAR(after.q[4 * k + 3], turned.z, 5e-16);
      }
    }
}

TEST(PlanarMotion, EndOfAStep) {
  for (const int count : {1, 2, 65}) {
    const Bodies before(count, 1.0);
    Bodies after = before;
    end_planar_step(after.rows(), count, half_step);
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      if (!(before.groups[k] & moving)) {
        expect_untouched(before, after, k);
        continue;
      }
      expect_kicked(before, after, k);
      expect_same_row(before.x, after.x, k, 3);
      expect_same_row(before.q, after.q, k, 4);
      EXPECT_EQ(after.f[3 * k + 2], 0.0);
      for (std::size_t l = 3 * k; l < 3 * k + 2; ++l) {
        EXPECT_EQ(after.f[l], before.f[l]);
        EXPECT_EQ(after.torque[l], 0.0);
        EXPECT_EQ(after.momentum[l], 0.0);
      }
    }
  }
}
