// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The time of a collision of ellipsoids: never longer than at any point of the surface.
#include "contact_families.h"
#include "law/time_scales.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace ellipsoid;
using namespace contact_test;

namespace {

struct Grain {
  Vector3 axes;
  double mass;
  Vector3 inertia;

  explicit Grain(const Vector3& a)
      : axes(a), mass(1340.0 * 4.0 / 3.0 * M_PI * a.x * a.y * a.z),
        inertia{0.2 * mass * (a.y * a.y + a.z * a.z), 0.2 * mass * (a.z * a.z + a.x * a.x),
                0.2 * mass * (a.x * a.x + a.y * a.y)} {}

  /// m*^2/R of two such bodies that meet with the points of this normal.
  double mass2_over_radius(const Vector3& n) const {
    const double s = std::sqrt(axes.x * axes.x * n.x * n.x + axes.y * axes.y * n.y * n.y +
                               axes.z * axes.z * n.z * n.z);
    const Vector3 r{axes.x * axes.x * n.x / s, axes.y * axes.y * n.y / s,
                    axes.z * axes.z * n.z / s};
    const Vector3 arm = cross(r, n);
    const double mobility = 1.0 / mass + arm.x * arm.x / inertia.x + arm.y * arm.y / inertia.y +
                            arm.z * arm.z / inertia.z;
    const double radius = 0.5 * axes.x * axes.y * axes.z / (s * s), reduced_mass = 0.5 / mobility;
    return reduced_mass * reduced_mass / radius;
  }

  /// The smallest over many normals, refined around the best.
  double smallest(PairGenerator& random) const {
    Vector3 best{1.0, 0.0, 0.0};
    const auto visit = [&](const Vector3& n) {
      if (mass2_over_radius(n) < mass2_over_radius(best))
        best = n;
    };
    for (int k = 0; k < 4000; ++k) { // spread over the sphere, and over the surface
      const Vector3 d = random.direction();
      visit(d);
      visit(normalized(Vector3{d.x / axes.x, d.y / axes.y, d.z / axes.z}));
    }
    for (double step = 0.3; step > 1e-5; step *= 0.9)
      for (int k = 0; k < 12; ++k) {
        const Vector3 d = step * random.direction();
        visit(normalized(best + Vector3{d.x * best.x, d.y * best.y, d.z * best.z}));
        visit(normalized(best + (step * 0.1) * d));
      }
    return mass2_over_radius(best);
  }
};

} // namespace

TEST(TimeScales, IsNeverAnOverestimate) {
  PairGenerator random(6017);
  double loosest = 1.0;
  for (int k = 0; k < 300; ++k) {
    const double a = 1e-3 * random.log_uniform(0.05, 20.0),
                 b = 1e-3 * random.log_uniform(0.05, 20.0),
                 c = 1e-3 * random.log_uniform(0.05, 20.0);
    const Vector3 shapes[] = {{a, b, c}, {a, b, b}, {b, a, b}, {b, b, a}};
    const Grain grain(shapes[k % 4]);
    const double brute = grain.smallest(random);
    const double found = smallest_mass2_over_radius(grain.axes, grain.mass, grain.inertia);
    ASSERT_LE(found, brute * (1.0 + 1e-12)) << "grain " << k;
    loosest = std::min(loosest, found / brute);
  }
  std::printf("smallest bound over brute force %.6f\n", loosest);
  EXPECT_GT(loosest, 0.9999); // 5e-5 of the bound, and what brute force misses
}

// Where a coarse search over the surface went wrong: 6.399e-5 s.
TEST(TimeScales, LongThinGrain) {
  const Grain grain({1e-2, 0.770531e-3, 1.89183e-3});
  const double modulus = 1e8 / (2.0 * (1.0 - 0.2 * 0.2)), speed = 2.0;
  const double time =
      hertz_time(smallest_mass2_over_radius(grain.axes, grain.mass, grain.inertia), modulus, speed);
  EXPECT_NEAR(time, 6.017e-5, 3e-8); // brute force over 4e6 points: 6.017e-5 s
}

TEST(TimeScales, Sphere) {
  const Grain ball({2e-3, 2e-3, 2e-3});
  EXPECT_NEAR(smallest_mass2_over_radius(ball.axes, ball.mass, ball.inertia),
              0.25 * ball.mass * ball.mass / 1e-3, 1e-14 * ball.mass * ball.mass / 1e-3);
}
