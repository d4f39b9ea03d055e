// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Neighbours of long bodies against points all over their surfaces: no pair is left out that is
// nearer than two margins.
#include "neighbours/long_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace ellipsoid {
namespace {

using Point = std::array<double, 3>;

double squared(const Point& a, const Point& b) {
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
         (a[2] - b[2]) * (a[2] - b[2]);
}

struct Scene {
  std::vector<double> centres, semiaxes, quaternions;
  std::mt19937_64 engine{17};

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  void add(double side, const Point& axes) {
    std::normal_distribution<double> normal;
    double q[4], length = 0.0;
    for (double& c : q) {
      c = normal(engine);
      length += c * c;
    }
    for (int k = 0; k < 4; ++k)
      quaternions.push_back(q[k] / std::sqrt(length));
    for (int k = 0; k < 3; ++k) {
      centres.push_back(uniform(0.0, side) - 0.3 * side);
      semiaxes.push_back(axes[static_cast<std::size_t>(k)]);
    }
  }
  std::size_t size() const { return centres.size() / 3; }

  /// Points of the surface and of the inside of body k, dense along its longest axis.
  std::vector<Point> points(std::size_t k) {
    const double *q = &quaternions[4 * k], w = q[0], x = q[1], y = q[2], z = q[3];
    const double turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                               {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                               {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    std::vector<Point> all;
    for (int n = 0; n < 300; ++n) { // a spiral from pole to pole
      const double height = (2.0 * n + 1.0) / 300.0 - 1.0, angle = 2.399963229728653 * n;
      const double ring = std::sqrt(1.0 - height * height);
      const double on_sphere[3] = {ring * std::cos(angle), ring * std::sin(angle), height};
      Point point{};
      for (std::size_t r = 0; r < 3; ++r) {
        point[r] = centres[3 * k + r];
        for (std::size_t c = 0; c < 3; ++c)
          point[r] += turn[r][c] * semiaxes[3 * k + c] * on_sphere[c];
      }
      all.push_back(point);
    }
    return all;
  }
};

/// Least distance of the points, or 0 where bodies overlap so far that the centre of one is in the
/// other: an upper bound of the gap.
double gap_bound(const std::vector<Point>& a, const std::vector<Point>& b) {
  double least = HUGE_VAL;
  for (const Point& p : a)
    for (const Point& q : b)
      least = std::min(least, squared(p, q));
  return std::sqrt(least);
}

/// @return share of the pairs that are neighbours
double expect_no_near_pair_missing(Scene& scene, double margin) {
  LongBodies bodies;
  std::vector<BodyBounds> bounds;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    const double* axes = &scene.semiaxes[3 * k];
    bounds.push_back(bounds_of_ellipsoid({axes[0], axes[1], axes[2]}));
  }
  bodies.build({scene.centres.data(), scene.quaternions.data(), bounds.data(), scene.size()},
               margin);
  std::vector<std::vector<Point>> points;
  for (std::size_t k = 0; k < scene.size(); ++k)
    points.push_back(scene.points(k));
  double listed = 0.0, pairs = 0.0;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const std::vector<int> found = bodies.find(static_cast<int>(i));
    const std::set<int> once(found.begin(), found.end());
    EXPECT_EQ(once.size(), found.size());
    listed += static_cast<double>(found.size());
    for (std::size_t j = i + 1; j < scene.size(); ++j) {
      pairs += 1.0;
      if (once.count(static_cast<int>(j)) == 0) {
        EXPECT_GT(gap_bound(points[i], points[j]), 2.0 * margin) << i << " and " << j;
      }
    }
    EXPECT_TRUE(once.empty() || *once.begin() > static_cast<int>(i));
  }
  return listed / pairs;
}

} // namespace

TEST(LongBodies, NoNearPairIsLeftOut) {
  const Point shapes[] = {{10.0, 0.5, 0.5}, {0.4, 8.0, 0.6}, {0.3, 0.3, 6.0}, {4.0, 4.0, 0.4},
                          {0.5, 3.0, 5.0},  {1.0, 1.0, 1.0}, {0.2, 0.1, 0.15}};
  for (const double margin : {0.0, 0.05, 0.6, 3.0}) {
    Scene scene;
    for (int k = 0; k < 105; ++k)
      scene.add(30.0, shapes[k % 7]);
    const double share = expect_no_near_pair_missing(scene, margin);
    EXPECT_GT(share, 0.0);
    EXPECT_LT(share, margin < 1.0 ? 0.15 : 0.5);
  }
}

/// Needles that lie beside each other, as in a bundle, and end to end.
TEST(LongBodies, ParallelNeedles) {
  Scene scene;
  for (int k = 0; k < 60; ++k) {
    scene.add(1.0, {12.0, 0.5, 0.5});
    std::fill_n(scene.quaternions.end() - 4, 4, 0.0);
    scene.quaternions[scene.quaternions.size() - 4] = 1.0;
    const double place[3] = {24.0 * (k % 3), 1.2 * (k % 20), 1.1 * (k / 20)};
    std::copy_n(place, 3, scene.centres.end() - 3);
  }
  EXPECT_LT(expect_no_near_pair_missing(scene, 0.2), 0.3);
}

TEST(LongBodies, CountsRatiosOfFourAsLong) {
  const double needle[3] = {1.0, 4.0, 1.0}, plate[3] = {4.1, 4.1, 1.0},
               grain[3] = {2.7, 1.15, 1.15};
  EXPECT_TRUE(LongBodies::is_long_or_flat(needle));
  EXPECT_TRUE(LongBodies::is_long_or_flat(plate));
  EXPECT_FALSE(LongBodies::is_long_or_flat(grain));
}

} // namespace ellipsoid
