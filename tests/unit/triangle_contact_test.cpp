// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contact with one triangle, against poses with a known answer, brute force, closed forms of the
// sphere, and invariances.
#include "contact_families.h"
#include "ellipsoid/ellipsoid_overlap.h"
#include "wall/triangle_contact.h"

#include <gtest/gtest.h>

using namespace ellipsoid;
using namespace contact_test;

namespace {

constexpr TriangleFeature features[] = {TriangleFeature::face, TriangleFeature::edge,
                                        TriangleFeature::corner};

struct Pose {
  Body body;
  Triangle triangle; // relative to the body's centre
  TriangleContact expected;
  double size = 0.0;
};

double largest(const Vector3& v) { return std::max({v.x, v.y, v.z}); }

Triangle moved(Triangle t, const Vector3& way) {
  for (Vector3& node : t)
    node += way;
  return t;
}

Triangle random_triangle(PairGenerator& random, double size) {
  for (;;) {
    Triangle t{size * random.direction(), size * random.direction(), size * random.direction()};
    if (norm(cross(t[1] - t[0], t[2] - t[0])) > 0.3 * size * size)
      return t;
  }
}

/// A point of the feature and a unit normal that the triangle supports there.
void place(PairGenerator& random, TriangleFeature feature, const Triangle& t, Vector3& foot,
           Vector3& n) {
  const double u = random.uniform(0.1, 0.8), v = random.uniform(0.1, 0.9) * (0.95 - u);
  const Vector3 edge = normalized(t[1] - t[0]);
  n = unit_normal(t);
  foot = t[0] + u * (t[1] - t[0]);
  if (feature == TriangleFeature::face) {
    foot += v * (t[2] - t[0]);
    n = random.uniform(-1.0, 1.0) > 0.0 ? n : -n;
  } else if (feature == TriangleFeature::edge) {
    do {
      n = random.direction();
      n = normalized(n - dot(n, edge) * edge);
    } while (dot(n, t[2] - t[0]) < 0.05);
  } else {
    foot = t[0];
    do
      n = random.direction();
    while (dot(n, t[1] - t[0]) < 0.05 || dot(n, t[2] - t[0]) < 0.05);
  }
}

/// A body that overlaps the feature by `depth` of its smallest radius of curvature: below 1 that
/// minimum of the overlap function is the only one (Blaschke).
Pose make_pose(PairGenerator& random, TriangleFeature feature, Family family, double aspect,
               double depth) {
  Pose p;
  p.body = random.body(family, 1.0, aspect);
  p.size = largest(p.body.semiaxes);
  const Triangle t = random_triangle(random, p.size * random.log_uniform(0.5, 20.0));
  Vector3 foot, n;
  place(random, feature, t, foot, n);
  const double overlap = depth * p.body.shape.smallest_curvature_radius;
  const Vector3 surface = (1.0 / support(p.body.shape, n)) * (p.body.shape.a_matrix * n);
  const Vector3 centre = foot + overlap * n - surface;
  p.triangle = moved(t, -centre);
  p.expected.feature = feature;
  p.expected.foot = foot - centre;
  p.expected.normal = n;
  p.expected.overlap = overlap;
  return p;
}

/// The smaller of the minima.
template <class Body>
TriangleContact find_triangle_contact(const Body& body, const Triangle& triangle) {
  TriangleContacts c = find_face_contact(body, triangle);
  if (c.boundary_may_touch)
    c.boundary = find_boundary_contact(body, triangle);
  const bool boundary =
      c.boundary.feature != TriangleFeature::none &&
      (c.face.feature == TriangleFeature::none || c.boundary.overlap < c.face.overlap);
  return boundary ? c.boundary : c.face_is_missed ? TriangleContact{} : c.face;
}

TriangleContact solve(const Pose& p) {
  return find_triangle_contact(EllipsoidBody(p.body.semiaxes, p.body.orientation), p.triangle);
}

/// Smallest value over a square by grids that shrink around the best point.
template <class Function>
double search(const Function& f, double u, double v, double half, int grid, double shrink) {
  double best = f(u, v);
  for (; half > 1e-13; half *= shrink) {
    const double middle_u = u, middle_v = v;
    for (int i = 0; i <= grid; ++i)
      for (int j = 0; j <= grid; ++j) {
        const double trial_u = middle_u + half * (2.0 * i / grid - 1.0);
        const double trial_v = middle_v + half * (2.0 * j / grid - 1.0);
        const double value = f(trial_u, trial_v);
        if (value < best) {
          best = value;
          u = trial_u;
          v = trial_v;
        }
      }
  }
  return best;
}

/// Smallest overlap over all normals as the largest depth over the triangle: the same by duality
/// while the overlap is below the smallest radius of curvature. No knowledge of features.
double brute_force(const Pose& p) {
  const Rotation3 axes = rotation(p.body.orientation);
  const auto height = [&](double u, double v) { // minus depth; the whole triangle from a square
    const double a = std::clamp(u, 0.0, 1.0), b = a * std::clamp(v, 0.0, 1.0);
    const Vector3 q = p.triangle[0] + (a - b) * (p.triangle[1] - p.triangle[0]) +
                      b * (p.triangle[2] - p.triangle[0]);
    const Vector3 local = axes.to_body(q), n = nearest_normal(p.body.semiaxes, local);
    const double support =
        norm({p.body.semiaxes.x * n.x, p.body.semiaxes.y * n.y, p.body.semiaxes.z * n.z});
    return dot(n, local) - support;
  };
  return -search(height, 0.5, 0.5, 0.5, 16, 0.6);
}

class TriangleFamily : public testing::TestWithParam<Family> {};

} // namespace

// The nearest surface point by its definition.
TEST_P(TriangleFamily, NearestNormalMatchesBruteForce) {
  PairGenerator random(30);
  int agree = 0; // the search may end at another minimum, which is then farther away
  for (int k = 0; k < 300; ++k) {
    const Body body = random.body(GetParam(), 1.0, 5.0);
    const Vector3& a = body.semiaxes;
    const Vector3 d = random.uniform(0.0, k % 2 ? 1.0 : 2.0) * random.direction();
    const Vector3 p{a.x * d.x, a.y * d.y, a.z * d.z}; // inside, or also outside
    Vector3 near = random.direction();                // on the unit sphere
    const auto distance_at = [&](const Vector3& y) {
      return norm(Vector3{a.x * y.x, a.y * y.y, a.z * y.z} - p);
    };
    for (int trial = 0; trial < 1000; ++trial) {
      const Vector3 y = random.direction();
      near = distance_at(y) < distance_at(near) ? y : near;
    }
    const TangentFrame t(near);
    const auto distance = [&](double u, double v) {
      return distance_at(normalized(near + u * t.first + v * t.second));
    };
    const double nearest = search(distance, 0.0, 0.0, 0.5, 20, 0.6);
    const Vector3 n = nearest_normal(a, p), an{a.x * n.x, a.y * n.y, a.z * n.z};
    const Vector3 foot = (1.0 / norm(an)) * Vector3{a.x * an.x, a.y * an.y, a.z * an.z};
    const double signed_distance = dot(n, p) - norm(an);
    ASSERT_LT(norm(p - foot - signed_distance * n), 1e-12 * largest(a)); // along the normal
    ASSERT_LT(std::fabs(signed_distance), nearest + 1e-12 * largest(a)) << "pose " << k;
    ASSERT_EQ(signed_distance > 0.0, dot(d, d) > 1.0);
    agree += std::fabs(std::fabs(signed_distance) - nearest) < 1e-12 * largest(a);
  }
  std::printf("search found the same point in %d of 300 poses\n", agree);
  EXPECT_GT(agree, 200);
}

TEST_P(TriangleFamily, FindsTheKnownContact) {
  PairGenerator random(31);
  double worst_overlap = 0.0, worst_normal = 0.0, worst_foot = 0.0;
  for (int k = 0; k < 60000; ++k) {
    const TriangleFeature feature = features[k % 3];
    const Pose p = make_pose(random, feature, GetParam(), 10.0, random.uniform(0.0, 0.5));
    const TriangleContact c = solve(p);
    ASSERT_EQ(c.feature, feature) << "pose " << k;
    worst_overlap = std::max(worst_overlap, std::fabs(c.overlap - p.expected.overlap) / p.size);
    worst_normal = std::max(worst_normal, norm(c.normal - p.expected.normal));
    worst_foot = std::max(worst_foot, norm(c.foot - p.expected.foot) / p.size);
    ASSERT_LT(norm(c.point - (c.foot + (0.5 * c.overlap) * c.normal)), 1e-14 * p.size);
    const double s = support(p.body.shape, c.normal);
    ASSERT_NEAR(c.reduced_radius,
                p.body.semiaxes.x * p.body.semiaxes.y * p.body.semiaxes.z / (s * s),
                1e-12 * c.reduced_radius);
  }
  std::printf("worst overlap %.1e, normal %.1e, foot %.1e\n", worst_overlap, worst_normal,
              worst_foot);
  EXPECT_LT(worst_overlap, 1e-13);
  EXPECT_LT(worst_normal, 1e-10);
  EXPECT_LT(worst_foot, 1e-10);
}

TEST_P(TriangleFamily, OverlapIsTheMinimumOverAllNormals) {
  PairGenerator random(32);
  double worst = 0.0;
  for (int k = 0; k < 150; ++k) {
    const Pose p = make_pose(random, features[k % 3], GetParam(), 4.0, random.uniform(0.05, 0.9));
    const double difference = (brute_force(p) - solve(p).overlap) / p.size;
    ASSERT_LT(difference, 1e-12) << "pose " << k;
    worst = std::max(worst, -difference); // the grids may stop short of the maximum
  }
  std::printf("largest difference from brute force %.1e\n", worst);
  EXPECT_LT(worst, 1e-7);
}

// d overlap / d displacement = normal, and the normal is steady: forces derive from a potential.
TEST_P(TriangleFamily, GradientOfTheOverlapIsTheNormal) {
  PairGenerator random(33);
  for (int k = 0; k < 3000; ++k) {
    Pose p = make_pose(random, features[k % 3], GetParam(), 5.0, random.uniform(0.1, 0.5));
    const TriangleContact c = solve(p);
    const Triangle before = p.triangle;
    const double step = 1e-6 * p.body.shape.smallest_curvature_radius;
    const Vector3 way = random.direction();
    p.triangle = moved(before, step * way);
    const double more = solve(p).overlap;
    p.triangle = moved(before, -step * way);
    const double less = solve(p).overlap;
    ASSERT_NEAR((more - less) / (2.0 * step), -dot(c.normal, way), 2e-7) << "pose " << k;
  }
}

TEST_P(TriangleFamily, MovingByTheOverlapSeparates) {
  PairGenerator random(34);
  for (int k = 0; k < 6000; ++k) {
    Pose p = make_pose(random, features[k % 3], GetParam(), 10.0, random.uniform(0.0, 0.9));
    const TriangleContact c = solve(p);
    const Triangle before = p.triangle;
    p.triangle = moved(before, (c.overlap + 1e-12 * p.size) * c.normal);
    ASSERT_EQ(solve(p).feature, TriangleFeature::none) << "pose " << k;
    p.triangle = moved(before, (c.overlap - 1e-6 * p.size) * c.normal);
    ASSERT_NE(solve(p).feature, TriangleFeature::none) << "pose " << k;
  }
}

TEST_P(TriangleFamily, OrderOfCornersScaleAndTurnDoNotMatter) {
  PairGenerator random(35);
  for (int k = 0; k < 3000; ++k) {
    Pose p = make_pose(random, features[k % 3], GetParam(), 10.0, random.uniform(0.0, 0.5));
    const TriangleContact c = solve(p);
    std::swap(p.triangle[0], p.triangle[1 + static_cast<std::size_t>(k % 2)]);
    ASSERT_NEAR(solve(p).overlap, c.overlap, 1e-13 * p.size);
    const double scale = random.log_uniform(1e-6, 1e6);
    const Quaternion turn = random.orientation();
    const Rotation3 r = rotation(turn);
    p.body.semiaxes *= scale;
    p.body.orientation = normalized(turn * p.body.orientation);
    for (Vector3& node : p.triangle)
      node = scale * r.to_space(node);
    const TriangleContact d = solve(p);
    ASSERT_EQ(d.feature, c.feature);
    ASSERT_NEAR(d.overlap, scale * c.overlap, 1e-12 * scale * p.size);
    ASSERT_LT(norm(d.normal - r.to_space(c.normal)), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, TriangleFamily,
                         testing::Values(Family::prolate, Family::oblate, Family::triaxial),
                         [](const auto& family) { return name(family.param); });

// A face gives exactly what the plane gives.
TEST(TriangleContact, FaceIsThePlane) {
  PairGenerator random(36);
  for (int k = 0; k < 1000; ++k) {
    const Pose p =
        make_pose(random, TriangleFeature::face, Family::triaxial, 10.0, random.uniform(0.0, 0.9));
    const TriangleContact c = solve(p);
    const ContactGeometry plane = find_plane_contact(p.body.shape, p.triangle[0], c.normal);
    EXPECT_EQ(c.overlap, plane.overlap);
    EXPECT_EQ(norm(c.point - plane.point), 0.0);
    EXPECT_EQ(c.reduced_radius, plane.curvature_radius_i);
  }
}

TEST(TriangleContact, SphereLimit) {
  PairGenerator random(37);
  for (int k = 0; k < 9000; ++k) {
    Pose p = make_pose(random, features[k % 3], Family::prolate, 1.0, random.uniform(0.0, 0.9));
    const Vector3 near = nearest_point(p.triangle, {});
    const TriangleContact c = solve(p);
    ASSERT_NEAR(c.overlap, 1.0 - norm(near), 1e-13);
    ASSERT_LT(norm(c.normal - normalized(near)), 1e-10);
    const TriangleContact s = find_triangle_contact(SphereBody{{}, 1.0, 0, false}, p.triangle);
    ASSERT_EQ(s.feature, c.feature);
    ASSERT_NEAR(s.overlap, c.overlap, 1e-13);
    ASSERT_LT(norm(s.foot - c.foot), 1e-10);
  }
}

// The nearest point of a triangle by projection and search over edges.
TEST(TriangleContact, NearestPointOfATriangle) {
  PairGenerator random(38);
  for (int k = 0; k < 20000; ++k) {
    const Triangle t = random_triangle(random, 1.0);
    const Vector3 p = random.uniform(0.0, 2.0) * random.direction();
    const Vector3 normal = unit_normal(t), flat = p - dot(normal, p - t[0]) * normal;
    const Vector3 weights = barycentric(t, flat);
    EXPECT_NEAR(weights.x + weights.y + weights.z, 1.0, 1e-12);
    double nearest = 1e9;
    if (weights.x >= 0.0 && weights.y >= 0.0 && weights.z >= 0.0)
      nearest = norm(flat - p);
    for (std::size_t e = 0; e < 3; ++e) {
      const Vector3 edge = t[(e + 1) % 3] - t[e];
      const double share = std::clamp(dot(edge, p - t[e]) / dot(edge, edge), 0.0, 1.0);
      nearest = std::min(nearest, norm(t[e] + share * edge - p));
    }
    ASSERT_NEAR(norm(nearest_point(t, p) - p), nearest, 1e-13);
  }
}

// Straight into a triangle's plane, however deep: the normal stays that of the front.
TEST(TriangleContact, DeepOverlapKeepsTheNormal) {
  const EllipsoidBody body({3.0, 1.0, 0.8}, Quaternion{0.8, 0.3, -0.4, 0.33166247903554});
  for (double height = 2.5; height > 0.01; height -= 0.01) {
    const Triangle t{Vector3{-50.0, -50.0, -height}, Vector3{50.0, -50.0, -height},
                     Vector3{0.0, 80.0, -height}};
    const TriangleContact c = find_triangle_contact(body, t);
    const double reach = support(body.shape, {0.0, 0.0, -1.0});
    if (reach < height) {
      EXPECT_EQ(c.feature, TriangleFeature::none);
      continue;
    }
    ASSERT_EQ(c.feature, TriangleFeature::face);
    EXPECT_EQ(c.normal.z, -1.0);
    EXPECT_NEAR(c.overlap, reach - height, 1e-14);
  }
}
