// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contact with a cylinder from inside and outside: brute force over the surface, closed forms, the
// limit of a plane, derivatives, and the two tips of a long body.
#include "contact_families.h"
#include "wall/cylinder_contact.h"

#include <gtest/gtest.h>

using namespace ellipsoid;
using namespace contact_test;

namespace {

/// Distances from the axis of many surface points, and the extreme ones by shrinking steps from the
/// best of them.
struct Brute {
  const Body& body;
  const Cylinder& cylinder;
  Rotation3 axes;

  Brute(const Body& b, const Cylinder& c) : body(b), cylinder(c), axes(rotation(b.orientation)) {}

  double distance(const Vector3& y) const { // y on the unit sphere
    const Vector3 p =
        axes.to_space({body.semiaxes.x * y.x, body.semiaxes.y * y.y, body.semiaxes.z * y.z}) -
        cylinder.centre;
    return norm(cross(cylinder.axis, p));
  }
  double extreme(double sign, PairGenerator& random) const {
    Vector3 best = random.direction();
    for (int k = 0; k < 4000; ++k) {
      const Vector3 y = random.direction();
      if (sign * distance(y) > sign * distance(best))
        best = y;
    }
    for (double step = 0.1; step > 1e-9; step *= 0.98) {
      for (int k = 0; k < 6; ++k) {
        const Vector3 y = normalized(best + step * random.direction());
        if (sign * distance(y) > sign * distance(best))
          best = y;
      }
    }
    return distance(best);
  }
};

Cylinder random_cylinder(PairGenerator& random, double radius, double distance) {
  Cylinder c;
  c.axis = random.direction();
  c.radius = radius;
  c.centre =
      distance * normalized(cross(c.axis, random.direction())) + random.uniform(-3.0, 3.0) * c.axis;
  return c;
}

std::vector<WallContact> solve(const EllipsoidBody& body, const Cylinder& cylinder) {
  std::vector<WallContact> contacts(3); // to be cleared
  find_cylinder_contacts(body, cylinder, contacts);
  return contacts;
}

std::vector<WallContact> solve(const Body& body, const Cylinder& cylinder) {
  return solve(EllipsoidBody(body.semiaxes, body.orientation), cylinder);
}

Cylinder moved(Cylinder c, const Vector3& way) {
  c.centre += way;
  return c;
}

double largest(const Vector3& v) { return std::max({v.x, v.y, v.z}); }

class CylinderFamily : public testing::TestWithParam<Family> {};

} // namespace

TEST_P(CylinderFamily, DeepestPointInside) {
  PairGenerator random(51);
  double worst = 0.0;
  int touching = 0;
  for (int k = 0; k < 150; ++k) {
    const Body body = random.body(GetParam(), 1.0, 5.0);
    const double radius = largest(body.semiaxes) * random.uniform(0.7, 3.0);
    const Cylinder cylinder = random_cylinder(random, radius, random.uniform(0.0, 0.99) * radius);
    const std::vector<WallContact> c = solve(body, cylinder);
    const double overlap = Brute(body, cylinder).extreme(1.0, random) - radius;
    if (std::fabs(overlap) < 1e-8)
      continue;
    ASSERT_EQ(!c.empty(), overlap > 0.0) << "pose " << k;
    if (c.empty())
      continue;
    ++touching;
    ASSERT_GT(c[0].overlap, overlap - 1e-12);
    worst = std::max(worst, c[0].overlap - overlap);
  }
  std::printf("%d touching, worst %.1e\n", touching, worst);
  EXPECT_GT(touching, 40);
  EXPECT_LT(worst, 1e-7);
}

TEST_P(CylinderFamily, DeepestPointOutside) {
  PairGenerator random(52);
  double worst = 0.0;
  int touching = 0;
  for (int k = 0; k < 150; ++k) {
    const Body body = random.body(GetParam(), 1.0, 5.0);
    const double radius = random.log_uniform(0.1, 10.0);
    const Cylinder cylinder = random_cylinder(
        random, radius, radius + random.uniform(0.01, 1.5) * largest(body.semiaxes));
    const std::vector<WallContact> c = solve(body, cylinder);
    const double overlap = radius - Brute(body, cylinder).extreme(-1.0, random);
    if (std::fabs(overlap) < 1e-8 || overlap > 0.99 * radius) // brute force has no signed distance
      continue;
    ASSERT_EQ(c.size(), overlap > 0.0 ? 1u : 0u) << "pose " << k;
    if (c.empty())
      continue;
    ++touching;
    worst = std::max(worst, std::fabs(c[0].overlap - overlap));
  }
  std::printf("%d touching, worst %.1e\n", touching, worst);
  EXPECT_GT(touching, 20);
  EXPECT_LT(worst, 1e-7);
}

// d overlap / d displacement of the wall = -normal, at every contact.
TEST_P(CylinderFamily, GradientOfTheOverlapIsTheNormal) {
  PairGenerator random(53);
  int pairs = 0;
  for (int k = 0; k < 4000; ++k) {
    const Body body = random.body(GetParam(), 1.0, 4.0);
    const bool inside = k % 2;
    const double radius = largest(body.semiaxes) * random.uniform(0.8, 2.0);
    const Cylinder cylinder =
        random_cylinder(random, radius,
                        inside ? random.uniform(0.0, 0.8) * radius
                               : radius + random.uniform(0.4, 0.9) * body.smallest_axis());
    const std::vector<WallContact> c = solve(body, cylinder);
    pairs += c.size() == 2;
    const double step = 1e-6;
    const Vector3 way = random.direction();
    const std::vector<WallContact> more = solve(body, moved(cylinder, step * way));
    const std::vector<WallContact> less = solve(body, moved(cylinder, -step * way));
    if (more.size() != c.size() || less.size() != c.size())
      continue; // just touching
    for (std::size_t m = 0; m < c.size(); ++m) {
      const WallContact &g = c[m], &a = more[m], &b = less[m];
      if (norm(a.normal - g.normal) + norm(b.normal - g.normal) > 1e-3)
        continue; // nearly of equal depth, and exchanged
      ASSERT_NEAR((a.overlap - b.overlap) / (2.0 * step), -dot(g.normal, way), 1e-5)
          << "pose " << k;
      ASSERT_NEAR(dot(g.normal, cylinder.axis), 0.0, 1e-14);
      const Vector3 middle = g.point - cylinder.centre;
      const double from_axis = norm(cross(cylinder.axis, middle));
      const double expected =
          inside ? radius + 0.5 * g.overlap : std::fabs(radius - 0.5 * g.overlap);
      ASSERT_NEAR(from_axis, expected, 1e-12);
    }
  }
  EXPECT_GT(pairs, 50);
}

TEST_P(CylinderFamily, AWideCylinderIsAPlane) {
  PairGenerator random(54);
  for (int k = 0; k < 1000; ++k) {
    const Body body = random.body(GetParam(), 1.0, 10.0);
    const double wide = 1e9;
    Cylinder cylinder = random_cylinder(random, wide, 1.0);
    const Vector3 outward = normalized(cross(cylinder.axis, random.direction()));
    const double distance = 0.95 * support(body.shape, outward);
    const double sign = k % 2 ? 1.0 : -1.0; // inside, outside
    cylinder.centre = (distance - sign * wide) * outward;
    const std::vector<WallContact> c = solve(body, cylinder);
    const ContactGeometry plane = find_plane_contact(body.shape, distance * outward, outward);
    ASSERT_EQ(c.size(), 1u);
    ASSERT_NEAR(c[0].overlap, plane.overlap, 1e-6);
    ASSERT_LT(norm(c[0].normal - plane.normal), 1e-6);
    ASSERT_NEAR(c[0].reduced_radius / plane.reduced_radius, 1.0, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, CylinderFamily,
                         testing::Values(Family::prolate, Family::oblate, Family::triaxial),
                         [](const auto& family) { return name(family.param); });

// Spheres: closed form, and eq. (19) with curvatures 1/r, and 1/r - 1/R or 1/r + 1/R.
TEST(CylinderContact, Sphere) {
  PairGenerator random(55);
  MultisphereTemplate ball;
  ball.centres = {0.0};
  ball.radii = {1.0};
  const MultisphereBody chain(ball);
  for (int k = 0; k < 2000; ++k) {
    const double r = random.log_uniform(0.1, 10.0), wall = r * random.uniform(1.2, 10.0);
    const bool inside = k % 2;
    const double overlap = random.uniform(0.001, 0.5) * r;
    const double distance = inside ? wall - r + overlap : wall + r - overlap;
    const Cylinder cylinder = random_cylinder(random, wall, distance);
    const EllipsoidBody body({r, r, r}, random.orientation());
    const std::vector<WallContact> c = solve(body, cylinder);
    ASSERT_EQ(c.size(), 1u);
    ASSERT_NEAR(c[0].overlap, overlap, 1e-12 * wall);
    const double curvature = 1.0 / r + (inside ? -1.0 : 1.0) / wall;
    ASSERT_NEAR(c[0].reduced_radius, 1.0 / std::sqrt(curvature / r), 1e-6 * c[0].reduced_radius);
    MultispherePose pose;
    pose.body = &chain;
    pose.scale = r;
    pose.axis = random.direction();
    std::vector<WallContact> spheres;
    find_cylinder_contacts(pose, cylinder, spheres);
    ASSERT_EQ(spheres.size(), 1u);
    ASSERT_NEAR(spheres[0].overlap, c[0].overlap, 1e-12 * wall);
    ASSERT_LT(norm(spheres[0].point - c[0].point), 1e-10 * wall);
    ASSERT_LT(norm(spheres[0].normal - c[0].normal), 1e-10);
    ASSERT_NEAR(spheres[0].reduced_radius, c[0].reduced_radius, 1e-12 * spheres[0].reduced_radius);
  }
}

// A long body across a tube touches with both tips, also exactly in the middle.
TEST(CylinderContact, BothTips) {
  for (const double offset : {0.0, 1e-14, 1e-3, 0.04}) {
    const EllipsoidBody body({5.0, 1.0, 1.0}, {});
    const std::vector<WallContact> c = solve(body, {{offset, 0.0, 7.0}, {0.0, 0.0, 1.0}, 4.9});
    ASSERT_EQ(c.size(), 2u) << offset;
    EXPECT_NEAR(c[0].overlap, 0.1 + offset, 1e-14);
    EXPECT_NEAR(c[1].overlap, 0.1 - offset, 1e-14);
    EXPECT_NEAR(std::fabs(c[1].normal.x), 1.0, 1e-14);
  }
  // beside the middle: the tips by hand, normals from the axis
  const EllipsoidBody body({5.0, 1.0, 1.0}, {});
  const std::vector<WallContact> c = solve(body, {{0.0, -3.0, 0.0}, {0.0, 0.0, 1.0}, 5.7});
  ASSERT_EQ(c.size(), 2u);
  double farthest = 0.0;
  for (int k = 0; k <= 1000000; ++k) {
    const double angle = 0.5 * M_PI * k / 1e6;
    farthest = std::max(farthest, std::hypot(5.0 * std::cos(angle), 3.0 + std::sin(angle)));
  }
  EXPECT_NEAR(c[0].overlap, farthest - 5.7, 1e-10);
  EXPECT_NEAR(c[1].overlap, c[0].overlap, 1e-14);
  EXPECT_NEAR(c[0].normal.x, -c[1].normal.x, 1e-14);
}
