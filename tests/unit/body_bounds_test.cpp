// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What bodies of spheres lie within, against points all over the spheres; neighbours among such
// bodies against the distances of all spheres.
#include "neighbours/body_bounds.h"

#include "math/vector3.h"
#include "multisphere/multisphere_body.h"
#include "multisphere/multisphere_template.h"
#include "neighbours/long_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace ellipsoid {
namespace {

std::mt19937_64 engine{23};

double uniform(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(engine);
}

Vector3 direction(int n, int count) { // of a spiral from pole to pole
  const double height = (2.0 * n + 1.0) / count - 1.0, angle = 2.399963229728653 * n;
  const double ring = std::sqrt(1.0 - height * height);
  return {ring * std::cos(angle), ring * std::sin(angle), height};
}

double gauge(const Vector3& axes, const Vector3& p) {
  return std::sqrt(p.x * p.x / (axes.x * axes.x) + p.y * p.y / (axes.y * axes.y) +
                   p.z * p.z / (axes.z * axes.z));
}

/// How far a point is from the segment of the capsule.
double to_segment(const BodyBounds& bounds, const Vector3& p) {
  const double along[] = {p.x, p.y, p.z};
  const double x = along[bounds.capsule_axis];
  const double beyond = std::max(0.0, std::fabs(x) - bounds.half_length);
  return std::sqrt(beyond * beyond + std::max(0.0, dot(p, p) - x * x));
}

struct Spheres {
  std::vector<Vector3> centres;
  std::vector<double> radii;
};

Spheres any_spheres(int count, const Vector3& extent) {
  Spheres set;
  for (int k = 0; k < count; ++k) {
    set.centres.push_back(
        {uniform(-extent.x, extent.x), uniform(-extent.y, extent.y), uniform(-extent.z, extent.z)});
    set.radii.push_back(uniform(0.2, 1.0));
  }
  return set;
}

Spheres rod(int count, int axis) {
  Spheres set;
  for (int k = 0; k < count; ++k) {
    const double x = k - 0.5 * (count - 1);
    set.centres.push_back({axis == 0 ? x : 0.0, axis == 1 ? x : 0.0, axis == 2 ? x : 0.0});
    set.radii.push_back(0.75);
  }
  return set;
}

Spheres chain(double aspect, int count, SphereSpacing spacing) {
  const MultisphereTemplate geometry = make_multisphere(aspect, 1.0, count, spacing);
  Spheres set;
  for (const double x : geometry.centres)
    set.centres.push_back({x, 0.0, 0.0});
  set.radii = geometry.radii;
  return set;
}

void expect_within(const Spheres& set, const BodyBounds& bounds) {
  for (std::size_t k = 0; k < set.radii.size(); ++k)
    for (int n = 0; n < 2000; ++n) {
      const Vector3 p = set.centres[k] + set.radii[k] * direction(n, 2000);
      EXPECT_LE(gauge(bounds.semiaxes, p), 1.0 + 1e-12);
      EXPECT_LE(to_segment(bounds, p), bounds.capsule_radius * (1.0 + 1e-12));
    }
}

/// A body's spheres in space.
Spheres placed(const Spheres& set, const Vector3& at, const Rotation3& turned) {
  Spheres moved = set;
  for (Vector3& c : moved.centres)
    c = at + c.x * turned.column_x + c.y * turned.column_y + c.z * turned.column_z;
  return moved;
}

double gap(const Spheres& a, const Spheres& b) {
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < a.radii.size(); ++k)
    for (std::size_t l = 0; l < b.radii.size(); ++l)
      least = std::min(least, norm(b.centres[l] - a.centres[k]) - a.radii[k] - b.radii[l]);
  return least;
}

} // namespace

TEST(BodyBounds, EnlargementHoldsABallAndTouchesIt) {
  for (int trial = 0; trial < 300; ++trial) {
    const Vector3 axes{uniform(0.3, 8.0), uniform(0.3, 8.0), uniform(0.3, 8.0)};
    Vector3 centre{uniform(-9.0, 9.0), uniform(-3.0, 3.0), uniform(-3.0, 3.0)};
    if (trial % 3 == 0) // on an axis, where the multiplier may be at its bound
      centre.y = centre.z = 0.0;
    if (trial % 30 == 0)
      centre.x = 0.0;
    const double radius = uniform(0.1, 4.0), factor = enlargement_for_ball(axes, centre, radius);
    double largest = 0.0;
    for (int n = 0; n < 20000; ++n)
      largest = std::max(largest, gauge(axes, centre + radius * direction(n, 20000)));
    EXPECT_LE(largest, factor * (1.0 + 1e-12));
    EXPECT_GE(largest, 0.999 * factor) << axes.x << ' ' << axes.y << ' ' << axes.z;
  }
}

TEST(BodyBounds, SpheresLieWithin) {
  const Spheres sets[] = {any_spheres(1, {3.0, 1.0, 0.5}),
                          any_spheres(20, {6.0, 0.5, 0.5}),
                          any_spheres(30, {0.5, 4.0, 7.0}),
                          any_spheres(10, {0.2, 0.2, 9.0}),
                          rod(9, 1),
                          rod(12, 2),
                          chain(2.4, 3, SphereSpacing::paper),
                          chain(6.0, 17, SphereSpacing::minimax_area),
                          chain(5.0, 5, SphereSpacing::minimax_area)};
  for (const Spheres& set : sets)
    expect_within(set, bounds_of_spheres(set.centres, set.radii));
}

TEST(BodyBounds, CapsuleOfARodIsTheRod) {
  const Spheres set = rod(9, 1);
  const BodyBounds bounds = bounds_of_spheres(set.centres, set.radii);
  EXPECT_EQ(bounds.capsule_axis, 1);
  EXPECT_DOUBLE_EQ(bounds.capsule_radius, 0.75);
  EXPECT_DOUBLE_EQ(bounds.half_length, 4.0);
  EXPECT_DOUBLE_EQ(bounds.turning_radius, 4.0);
}

TEST(BodyBounds, ChainWithinItsEllipsoidKeepsIt) {
  const Spheres set = chain(10.0, 27, SphereSpacing::paper);
  const BodyBounds bounds = bounds_of_spheres(set.centres, set.radii);
  EXPECT_NEAR(bounds.semiaxes.x, 10.0, 0.2);
  EXPECT_NEAR(bounds.semiaxes.y, 1.0, 0.02);
}

TEST(LongBodies, NoNearPairOfSphereSetsIsLeftOut) {
  const Spheres kinds[] = {rod(14, 0), rod(9, 2), any_spheres(12, {5.0, 0.3, 0.2}),
                           any_spheres(25, {4.0, 0.1, 4.0}),
                           chain(10.0, 9, SphereSpacing::minimax_area)};
  std::normal_distribution<double> normal;
  for (const double margin : {0.0, 0.3, 2.0}) {
    std::vector<double> centres, quaternions;
    std::vector<BodyBounds> bounds;
    std::vector<Spheres> bodies;
    for (std::size_t k = 0; k < 100; ++k) {
      const Spheres& kind = kinds[k % 5];
      const Vector3 at{uniform(-14.0, 14.0), uniform(-14.0, 14.0), uniform(-14.0, 14.0)};
      double q[4], length = 0.0;
      for (double& c : q) {
        c = normal(engine);
        length += c * c;
      }
      for (double& c : q)
        quaternions.push_back(c /= std::sqrt(length));
      centres.insert(centres.end(), {at.x, at.y, at.z});
      bounds.push_back(bounds_of_spheres(kind.centres, kind.radii));
      bodies.push_back(placed(kind, at, rotation({q[0], q[1], q[2], q[3]})));
    }
    LongBodies near;
    near.build({centres.data(), quaternions.data(), bounds.data(), bodies.size()}, margin);
    std::size_t listed = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const std::vector<int> found = near.find(static_cast<int>(i));
      const std::set<int> once(found.begin(), found.end());
      listed += once.size();
      for (std::size_t j = i + 1; j < bodies.size(); ++j)
        if (once.count(static_cast<int>(j)) == 0) {
          EXPECT_GT(gap(bodies[i], bodies[j]), 2.0 * margin) << i << " and " << j;
        }
    }
    EXPECT_GT(listed, 100U);
    EXPECT_LT(listed, margin < 1.0 ? 1000U : 3000U); // of 4950
  }
}

} // namespace ellipsoid
