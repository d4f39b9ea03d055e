// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// First gaps against the distance of points on the two surfaces, and against the exact one.
#include "ellipsoid/first_gaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ellipsoid {
namespace {

struct Bodies {
  std::mt19937_64 engine{31};
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> uniform{0.0, 1.0};

  Vector3 direction() { return normalized(Vector3{gauss(engine), gauss(engine), gauss(engine)}); }
  /// Long, flat or neither, longest axis anywhere; volume 1.
  Vector3 axes(double aspect) {
    double a[3] = {aspect, 1.0, uniform(engine) < 0.5 ? aspect : 1.0 + uniform(engine)};
    std::shuffle(a, a + 3, engine);
    const double scale = std::cbrt(a[0] * a[1] * a[2]);
    return {a[0] / scale, a[1] / scale, a[2] / scale};
  }
  Quaternion orientation() {
    return normalized(Quaternion{gauss(engine), gauss(engine), gauss(engine), gauss(engine)});
  }
};

/// A point of the surface of an ellipsoid about the origin.
Vector3 on_surface(const Vector3& axes, const Quaternion& q, const Vector3& u) {
  const auto r = rotation(q);
  return axes.x * u.x * r.column_x + axes.y * u.y * r.column_y + axes.z * u.z * r.column_z;
}

} // namespace

TEST(FirstGaps, NoTwoPointsOfTheBodiesAreNearer) {
  Bodies bodies;
  int apart = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const double aspect = std::pow(20.0, bodies.uniform(bodies.engine));
    FirstGaps batch;
    struct {
      Vector3 axes[2], distance;
      Quaternion q[2];
    } pairs[Batch::capacity];
    const int count = 1 + scene % Batch::capacity;
    for (int k = 0; k < count; ++k) {
      auto& p = pairs[k];
      for (int body : {0, 1}) {
        p.axes[body] = bodies.axes(aspect);
        p.q[body] = bodies.orientation();
      }
      p.distance = 3.0 * std::cbrt(aspect) * bodies.direction();
      batch.add(make_shape(p.axes[0], p.q[0]), make_shape(p.axes[1], p.q[1]), p.distance);
    }
    batch.find();
    for (int k = 0; k < count; ++k) {
      EXPECT_NEAR(norm(batch.normal(k)), 1.0, 1e-14);
      if (!(batch.gap(k) > 0.0))
        continue;
      ++apart;
      for (int point = 0; point < 200; ++point) {
        const Vector3 i = on_surface(pairs[k].axes[0], pairs[k].q[0], bodies.direction()),
                      j = on_surface(pairs[k].axes[1], pairs[k].q[1], bodies.direction());
        ASSERT_GE(norm(pairs[k].distance + j - i), batch.gap(k) * (1.0 - 1e-12));
      }
    }
  }
  EXPECT_GT(apart, 200);
}

TEST(FirstGaps, AreNotMuchShorterThanTheDistance) {
  Bodies bodies;
  int near = 0, kept = 0;
  const double skin = 0.5;
  for (int pair = 0; pair < 5000; ++pair) {
    const EllipsoidShape i = make_shape(bodies.axes(10.0), bodies.orientation()),
                         j = make_shape(bodies.axes(10.0), bodies.orientation());
    const Vector3 distance = 9.0 * std::cbrt(bodies.uniform(bodies.engine)) * bodies.direction();
    FirstGaps batch;
    batch.add(i, j, distance);
    batch.find();
    kept += !(batch.gap(0) > skin);
    SearchOptions options;
    options.goal = SearchGoal::distance;
    near += !(-find_contact(i, j, distance, options).overlap > skin);
  }
  EXPECT_GE(kept, near);
  EXPECT_LT(kept, 1.25 * near);
}

TEST(FirstGaps, OfSpheresAreTheDistance) {
  const EllipsoidShape small = make_shape({0.5, 0.5, 0.5}, {}), large = make_shape({3, 3, 3}, {});
  FirstGaps batch;
  batch.add(small, large, {0.0, 3.0, -4.0});
  batch.add(large, small, {0.0, 0.0, 3.0});
  batch.add(large, small, {0.0, 0.0, 0.0});
  batch.find();
  EXPECT_NEAR(batch.gap(0), 1.5, 1e-14);
  EXPECT_NEAR(batch.normal(0).y, 0.6, 1e-15);
  EXPECT_NEAR(batch.gap(1), -0.5, 1e-14);
  EXPECT_TRUE(std::isnan(batch.gap(2)));
}

} // namespace ellipsoid
