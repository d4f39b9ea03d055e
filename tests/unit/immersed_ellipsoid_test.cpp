// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The part of an ellipsoid below a plane, against a lattice of points in it and the sphere's
// formula.
#include "ellipsoid/immersed_ellipsoid.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ellipsoid;

namespace {

constexpr int points_across = 120;

/// Sum over a lattice of the body's points: volume and centroid of what lies lower than `depth`
/// above the centre.
ImmersedPart by_lattice(const Vector3& semiaxes, const Quaternion& q, const Vector3& up,
                        double depth) {
  const Rotation3 r = rotation(q);
  const double step = 2.0 / points_across;
  Vector3 sum;
  double count = 0.0;
  for (int i = 0; i < points_across; ++i)
    for (int j = 0; j < points_across; ++j)
      for (int k = 0; k < points_across; ++k) {
        const Vector3 u{step * (i + 0.5) - 1.0, step * (j + 0.5) - 1.0, step * (k + 0.5) - 1.0};
        if (dot(u, u) > 1.0)
          continue;
        const Vector3 p = r.to_space({semiaxes.x * u.x, semiaxes.y * u.y, semiaxes.z * u.z});
        if (dot(p, up) > depth)
          continue;
        sum += p;
        count += 1.0;
      }
  return {count * step * step * step * semiaxes.x * semiaxes.y * semiaxes.z,
          count > 0.0 ? (1.0 / count) * sum : Vector3{}};
}

TEST(ImmersedEllipsoid, agrees_with_a_lattice_of_points) {
  const Vector3 semiaxes{2.7, 1.9, 1.1};
  const Quaternion q = normalized(Quaternion{0.8, -0.3, 0.5, 0.2});
  const Vector3 up = normalized(Vector3{0.3, -0.5, 0.8});
  const double whole = volume(semiaxes), longest = semiaxes.x;
  for (const double depth : {-1.2, -0.4, 0.0, 0.3, 1.0}) {
    const ImmersedPart part = immersed_part(semiaxes, q, up, depth),
                       lattice = by_lattice(semiaxes, q, up, depth);
    EXPECT_NEAR(part.volume, lattice.volume, 3e-3 * whole) << depth;
    EXPECT_LT(norm(part.volume * part.centroid - lattice.volume * lattice.centroid),
              3e-3 * whole * longest)
        << depth;
  }
}

TEST(ImmersedEllipsoid, a_sphere_is_the_segment_of_a_ball) {
  const double radius = 1.7, depth = 0.4, height = radius + depth;
  const ImmersedPart part = immersed_part({radius, radius, radius}, {}, {0.0, 0.0, 1.0}, depth);
  EXPECT_NEAR(part.volume, M_PI * height * height * (3.0 * radius - height) / 3.0, 1e-12);
  EXPECT_NEAR(part.centroid.z, -0.75 * std::pow(2.0 * radius - height, 2) / (3.0 * radius - height),
              1e-12);
}

TEST(ImmersedEllipsoid, nothing_above_and_everything_below) {
  const Vector3 semiaxes{2.7, 1.9, 1.1};
  const Vector3 up{0.0, 1.0, 0.0};
  EXPECT_EQ(immersed_part(semiaxes, {}, up, -1.9).volume, 0.0);
  const ImmersedPart below = immersed_part(semiaxes, {}, up, 5.0);
  EXPECT_DOUBLE_EQ(below.volume, volume(semiaxes));
  EXPECT_EQ(norm(below.centroid), 0.0);
}

} // namespace
