// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "insertion/occupied_space.h"

#include "multisphere/multisphere_template.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ellipsoid {
namespace {

constexpr double pi = 3.14159265358979323846;

struct Pose {
  Vector3 centre, semiaxes;
  Quaternion orientation;
  SolidBody body() const { return smooth_body(centre, semiaxes, orientation); }
};

class Poses {
 public:
  explicit Poses(unsigned seed) : random_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector3 place(double half) {
    return {uniform(-half, half), uniform(-half, half), uniform(-half, half)};
  }
  Quaternion orientation() {
    std::normal_distribution<double> normal;
    return normalized(
        Quaternion{normal(random_), normal(random_), normal(random_), normal(random_)});
  }
  Pose pose(double half, double smallest, double largest) {
    const auto axis = [&] { return smallest * std::pow(largest / smallest, uniform(0.0, 1.0)); };
    const double a = axis(), b = axis(), c = axis();
    return {place(half), {a, b, c}, orientation()};
  }

 private:
  std::mt19937 random_;
};

/// Solves M x = d of a symmetric 3 x 3 matrix by Cramer's rule; returns d.x.
double quadratic_of_inverse(const SymmetricMatrix3& m, const Vector3& d) {
  const Vector3 first{m.xx, m.xy, m.xz}, second{m.xy, m.yy, m.yz}, third{m.xz, m.yz, m.zz};
  const double det = dot(first, cross(second, third));
  const Vector3 x = (1.0 / det) * (d.x * cross(second, third) + d.y * cross(third, first) +
                                   d.z * cross(first, second));
  return dot(d, x);
}

/// Contact function of Perram and Wertheim 1985: less than 1 exactly if the ellipsoids overlap.
double perram_wertheim(const Pose& i, const Pose& j) {
  const SymmetricMatrix3 a = make_shape(i.semiaxes, i.orientation).a_matrix,
                         b = make_shape(j.semiaxes, j.orientation).a_matrix;
  const Vector3 d = j.centre - i.centre;
  const auto value = [&](double s) {
    return s * (1.0 - s) * quadratic_of_inverse((1.0 - s) * a + s * b, d);
  };
  double low = 0.0, high = 1.0; // concave: golden section
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  for (int k = 0; k < 100; ++k) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (value(left) < value(right) ? low : high) = value(left) < value(right) ? left : right;
  }
  return value(0.5 * (low + high));
}

TEST(SolidBody, OverlapIsThatOfPerramAndWertheim) {
  Poses poses(4711);
  int overlapping = 0, apart = 0;
  for (int k = 0; k < 20000; ++k) {
    const Pose i = poses.pose(1.0, 0.1, 2.0), j = poses.pose(1.7, 0.1, 2.0);
    const double function = perram_wertheim(i, j);
    if (std::fabs(function - 1.0) < 1e-9)
      continue;
    EXPECT_EQ(overlap(i.body(), j.body()), function < 1.0) << function;
    EXPECT_EQ(overlap(j.body(), i.body()), function < 1.0);
    (function < 1.0 ? overlapping : apart)++;
  }
  EXPECT_GT(overlapping, 2000);
  EXPECT_GT(apart, 3000);
}

SolidBody chain_at(const MultisphereBody& chain, const Vector3& centre, const Vector3& axis,
                   double scale) {
  return multisphere_body(centre, {&chain, axis, scale});
}

TEST(SolidBody, ChainsOverlapWhereSpheresDo) {
  Poses poses(815);
  const MultisphereBody slender(make_multisphere(2.7, 1.0, 9)),
      round(make_multisphere(1.3, 1.0, 5));
  int found[2] = {0, 0};
  for (int k = 0; k < 5000; ++k) {
    const SolidBody i = chain_at(slender, poses.place(1.0), normalized(poses.place(1.0)), 0.9),
                    j = chain_at(round, poses.place(3.0), normalized(poses.place(1.0)), 1.4);
    bool touching = false;
    for (int p = 0; p < slender.count(); ++p)
      for (int q = 0; q < round.count(); ++q) {
        const Vector3 d = j.centre + (1.4 * round.abscissa(q)) * j.spheres.axis -
                          (i.centre + (0.9 * slender.abscissa(p)) * i.spheres.axis);
        touching = touching || norm(d) < 0.9 * slender.radius(p) + 1.4 * round.radius(q);
      }
    EXPECT_EQ(overlap(i, j), touching);
    ++found[touching];
    // with a smooth ball of the same place as the middle sphere
    const SolidBody ball = smooth_body(j.centre, {1.4, 1.4, 1.4}, {});
    bool touches_ball = false;
    for (int p = 0; p < slender.count(); ++p)
      touches_ball =
          touches_ball || norm(j.centre - i.centre - (0.9 * slender.abscissa(p)) * i.spheres.axis) <
                              0.9 * slender.radius(p) + 1.4;
    EXPECT_EQ(overlap(i, ball), touches_ball);
    EXPECT_EQ(overlap(ball, i), touches_ball);
  }
  EXPECT_GT(std::min(found[0], found[1]), 500);
}

/// Points of the surface, evenly in the angles.
template <class Action> void for_points(const Pose& pose, const Action& action) {
  const Rotation3 r = rotation(pose.orientation);
  constexpr int steps = 120;
  for (int p = 0; p <= steps; ++p)
    for (int q = 0; q < 2 * steps; ++q) {
      const double theta = pi * p / steps, phi = pi * q / steps;
      action(pose.centre + r.to_space({pose.semiaxes.x * std::sin(theta) * std::cos(phi),
                                       pose.semiaxes.y * std::sin(theta) * std::sin(phi),
                                       pose.semiaxes.z * std::cos(theta)}));
    }
}

TEST(SolidBody, WhatOverlapsTheInscribedBallOverlapsTheBody) {
  Poses poses(11);
  const MultisphereBody slender(make_multisphere(2.7, 1.0, 9));
  int found[2] = {0, 0};
  for (int k = 0; k < 6000; ++k) {
    const Pose pose = poses.pose(1.5, 0.2, 1.0), other = poses.pose(1.5, 0.2, 1.0);
    const SolidBody chain = chain_at(slender, poses.place(1.5), normalized(poses.place(1.0)), 0.3);
    const Vector3& s = pose.semiaxes;
    EXPECT_EQ(inscribed_ball(pose.body()).bounding_radius, std::min({s.x, s.y, s.z}));
    EXPECT_EQ(inscribed_ball(chain).bounding_radius, 0.3 * slender.radius(4));
    for (const SolidBody& body : {pose.body(), chain}) {
      const bool ball_does = overlap(inscribed_ball(body), other.body());
      EXPECT_TRUE(!ball_does || overlap(body, other.body()));
      ++found[ball_does];
    }
  }
  EXPECT_GT(std::min(found[0], found[1]), 500);
}

TEST(SolidBody, LiesWithinBlockBallAndCylinder) {
  Poses poses(99);
  constexpr double margin = 2e-3; // points miss the farthest one by less
  int inside[3] = {0, 0, 0}, outside[3] = {0, 0, 0};
  for (int k = 0; k < 300; ++k) {
    const Pose pose = poses.pose(0.6, 0.2, 0.9);
    const int axis = k % 3;
    double excess[3] = {-1e9, -1e9, -1e9}; // of the farthest point over block, ball, cylinder
    for_points(pose, [&](const Vector3& x) {
      const double along[3] = {x.x, x.y, x.z};
      const double u = along[(axis + 1) % 3], v = along[(axis + 2) % 3];
      excess[0] =
          std::max({excess[0], std::fabs(x.x) - 1.0, std::fabs(x.y) - 1.1, std::fabs(x.z) - 1.2});
      excess[1] = std::max(excess[1], norm(x) - 1.1);
      excess[2] = std::max({excess[2], std::hypot(u, v) - 1.0, std::fabs(along[axis]) - 1.1});
    });
    const SolidBody body = pose.body();
    const bool found[3] = {is_inside_block(body, {-1.0, -1.1, -1.2}, {1.0, 1.1, 1.2}),
                           is_inside_ball(body, {}, 1.1),
                           is_inside_cylinder(body, axis, {}, 1.0, -1.1, 1.1)};
    for (int what = 0; what < 3; ++what) {
      if (excess[what] > 0.0) {
        EXPECT_FALSE(found[what]) << excess[what];
        ++outside[what];
      } else if (excess[what] < -margin) {
        EXPECT_TRUE(found[what]) << excess[what];
        ++inside[what];
      }
    }
  }
  for (int what = 0; what < 3; ++what) {
    EXPECT_GT(inside[what], 30);
    EXPECT_GT(outside[what], 30);
  }
}

TEST(SolidBody, FarthestDistanceInSpecialPlaces) {
  EXPECT_NEAR((farthest_squared_distance<3>({4.0, 1.0, 0.25}, {0.0, 0.0, 0.0})), 4.0, 1e-12);
  EXPECT_NEAR((farthest_squared_distance<3>({4.0, 1.0, 0.25}, {3.0, 0.0, 0.0})), 25.0, 1e-9);
  EXPECT_NEAR((farthest_squared_distance<2>({1.0, 1.0}, {3.0, 4.0})), 36.0, 1e-9);
  // centre on the short axis: the farthest point leaves it, x = 2 sqrt(1 - y^2), largest at y = 1/3
  EXPECT_NEAR((farthest_squared_distance<2>({4.0, 1.0}, {0.0, 1.0})),
              4.0 * (1.0 - 1.0 / 9.0) + 16.0 / 9.0, 1e-9);
}

TEST(SolidBody, ChainWithinRegions) {
  const MultisphereBody chain(make_multisphere(2.0, 1.0, 5));
  const SolidBody body = chain_at(chain, {0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1.0);
  EXPECT_TRUE(is_inside_block(body, {-1.5001, -1.0001, -1.0001}, {2.5001, 1.0001, 1.0001}));
  EXPECT_FALSE(is_inside_block(body, {-1.5001, -1.0001, -1.0001}, {2.4999, 1.0001, 1.0001}));
  EXPECT_TRUE(is_inside_ball(body, {}, 2.5001));
  EXPECT_FALSE(is_inside_ball(body, {}, 2.4999));
  EXPECT_TRUE(is_inside_cylinder(body, 0, {}, 1.0001, -1.5001, 2.5001));
  EXPECT_FALSE(is_inside_cylinder(body, 0, {}, 0.9999, -1.5001, 2.5001));
  EXPECT_FALSE(is_inside_cylinder(body, 2, {}, 2.4999, -3.0, 3.0));
  EXPECT_TRUE(is_inside_cylinder(body, 2, {}, 2.5001, -1.0001, 1.0001));
}

TEST(OccupiedSpace, FindsAllBodiesOfAllSizes) {
  for (const double ratio : {1.0, 3.0, 50.0}) {
    Poses poses(static_cast<unsigned>(ratio));
    OccupiedSpace space;
    std::vector<SolidBody> bodies;
    int taken = 0;
    for (int k = 0; k < 3000; ++k) {
      const SolidBody body = poses.pose(5.0, 0.4 / ratio, 0.9).body();
      const bool is_free = std::none_of(bodies.begin(), bodies.end(), [&](const SolidBody& other) {
        return overlap(body, other);
      });
      ASSERT_EQ(space.is_free(body), is_free);
      taken += !is_free;
      if (is_free || k % 7 == 0) {
        space.add(body);
        bodies.push_back(body);
      }
    }
    EXPECT_GT(taken, 300);
    EXPECT_EQ(space.size(), bodies.size());
  }
}

} // namespace
} // namespace ellipsoid
