// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts searched in batches against the search of single pairs.
#include "contact_families.h"
#include "ellipsoid/contact_batch.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace ellipsoid;
using namespace contact_test;

namespace {

struct Case {
  Pair pair;
  Vector3 start;
};

/// Pairs near contact, with a start that is off by an angle between 1e-10 and 0.3 rad.
std::vector<Case> make_cases(Family family, int count) {
  PairGenerator random(40100);
  std::vector<Case> cases;
  while (static_cast<int>(cases.size()) < count) {
    Case c{random.pair(family, 20.0, 20.0, random.uniform(-0.005, 0.1)), {}};
    const ContactGeometry g = find_contact(c.pair.i.shape, c.pair.j.shape, c.pair.centre_distance);
    c.start = normalized(g.normal + random.log_uniform(1e-10, 0.3) * random.direction());
    cases.push_back(c);
  }
  return cases;
}

/// Results of all cases, in batches of at most `batch_size`.
std::vector<ContactGeometry> solve(const std::vector<Case>& cases, int batch_size) {
  std::vector<ContactGeometry> results;
  ContactBatch batch;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Pair& p = cases[k].pair;
    batch.add(p.i.shape, p.j.shape, p.centre_distance, cases[k].start);
    if (batch.size() < batch_size && k + 1 < cases.size())
      continue;
    batch.solve();
    for (int m = 0; m < batch.size(); ++m)
      results.push_back(batch.geometry(m));
    batch.clear();
  }
  return results;
}

bool same_bits(const ContactGeometry& a, const ContactGeometry& b) {
  const auto values = [](const ContactGeometry& c) {
    return std::vector<double>{c.normal.x,          c.normal.y,       c.normal.z,
                               c.point.x,           c.point.y,        c.point.z,
                               c.overlap,           c.reduced_radius, c.curvature_radius_i,
                               c.curvature_radius_j};
  };
  const std::vector<double> p = values(a), q = values(b);
  return a.status == b.status && std::memcmp(p.data(), q.data(), p.size() * sizeof(double)) == 0;
}

class ContactBatchTest : public testing::TestWithParam<Family> {};

} // namespace

// The normal to a few of its stated errors (1e-12 rad), point and radii to that times the aspect
// ratio's share (radii change by up to 60 per rad at aspect 20), the overlap to rounding.
TEST_P(ContactBatchTest, AgreesWithTheSearchOfSinglePairs) {
  const std::vector<Case> cases = make_cases(GetParam(), 20000);
  const std::vector<ContactGeometry> results = solve(cases, ContactBatch::capacity);
  int touching = 0, apart = 0;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Pair& p = cases[k].pair;
    const ContactGeometry single = find_contact(p.i.shape, p.j.shape, p.centre_distance);
    const ContactGeometry& batch = results[k];
    ASSERT_EQ(batch.status, single.status) << "pair " << k;
    if (single.status == ContactStatus::separated) {
      ++apart;
      ASSERT_LT(overlap_along(p.i.shape, p.j.shape, p.centre_distance, batch.normal), 0.0);
      continue;
    }
    ++touching;
    const double size = norm(p.centre_distance);
    ASSERT_LT(norm(batch.normal - single.normal), 3e-12) << "pair " << k;
    ASSERT_LT(norm(batch.point - single.point), 3e-11 * size) << "pair " << k;
    ASSERT_LT(std::fabs(batch.overlap - single.overlap), 1e-13 * size) << "pair " << k;
    ASSERT_LT(std::fabs(batch.reduced_radius / single.reduced_radius - 1.0), 1e-9) << "pair " << k;
    ASSERT_LT(std::fabs(batch.curvature_radius_i / single.curvature_radius_i - 1.0), 1e-9);
    ASSERT_LT(std::fabs(batch.curvature_radius_j / single.curvature_radius_j - 1.0), 1e-9);
  }
  EXPECT_GT(touching, 10000);
  EXPECT_GT(apart, 500);
}

// Whoever else is in the batch: the same bits.
TEST_P(ContactBatchTest, ResultsDoNotDependOnTheCompany) {
  const std::vector<Case> cases = make_cases(GetParam(), 2000);
  const std::vector<ContactGeometry> full = solve(cases, ContactBatch::capacity);
  for (const int size : {1, 3, 17}) {
    const std::vector<ContactGeometry> results = solve(cases, size);
    for (std::size_t k = 0; k < cases.size(); ++k)
      ASSERT_TRUE(same_bits(results[k], full[k])) << "pair " << k << ", batches of " << size;
  }
}

// Flat on flat, where the radii of curvature have no first change but a large second one; and
// overlaps as deep as the radii of curvature, where the Hessian is nearly singular.
TEST(ContactBatch, IsExactOnFlatSidesAndInDeepOverlap) {
  const auto worst = [](const Vector3& axes, double overlap, double turn) {
    const EllipsoidShape shape = make_shape(axes, Quaternion{});
    const Vector3 distance{0.0, 2.0 * axes.y - overlap, 0.0};
    ContactBatch batch;
    batch.add(shape, shape, distance, normalized(Vector3{turn, 1.0, 0.5 * turn}));
    batch.solve();
    const ContactGeometry g = batch.geometry(0);
    EXPECT_EQ(g.status, ContactStatus::touching);
    EXPECT_NEAR(norm(g.normal), 1.0, 1e-15);
    EXPECT_NEAR(g.overlap, overlap_along(shape, shape, distance, g.normal), 1e-14 * axes.y);
    return norm(g.normal - Vector3{0.0, 1.0, 0.0});
  };
  for (const double aspect : {1.0, 2.0, 5.0, 20.0, 100.0})
    for (double turn = 1e-7; turn < 1e-3; turn *= 1.3)
      EXPECT_LT(worst({aspect, 1.0, aspect}, 1e-4, turn), 1e-12) << aspect << ", " << turn;
  for (const double aspect : {1.5, 5.0, 20.0}) // tip to tip
    for (double turn = 1e-7; turn < 1e-3; turn *= 1.3)
      for (const double share : {0.1, 0.5, 0.9, 0.99})
        EXPECT_LT(worst({1.0, aspect, 1.0}, share * 2.0 / aspect, turn), 3e-12)
            << aspect << ", " << turn << ", " << share;
}

// Spheres with their centres almost at the same place: any direction will do, but a unit vector.
TEST(ContactBatch, GivesUnitNormalsToCoincidingSpheres) {
  PairGenerator random(40103);
  const EllipsoidShape sphere = make_shape({1.0, 1.0, 1.0}, Quaternion{});
  for (int k = 0; k < 20000; ++k) {
    const Vector3 direction = random.direction();
    const Vector3 start =
        normalized(direction + random.log_uniform(1e-8, 1e-2) * random.direction());
    ContactBatch batch;
    batch.add(sphere, sphere, random.log_uniform(1e-14, 1e-4) * direction, start);
    batch.solve();
    ASSERT_NEAR(norm(batch.geometry(0).normal), 1.0, 1e-15);
  }
}

// A pair across two ranks is computed by both, with i and j swapped: action is reaction to the last
// bit.
TEST_P(ContactBatchTest, SwappedPairsHaveTheSameBits) {
  const std::vector<Case> cases = make_cases(GetParam(), 5000);
  std::vector<Case> swapped;
  for (const Case& c : cases)
    swapped.push_back({{c.pair.j, c.pair.i, -c.pair.centre_distance}, -c.start});
  const std::vector<ContactGeometry> forth = solve(cases, ContactBatch::capacity),
                                     back = solve(swapped, ContactBatch::capacity);
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const ContactGeometry &f = forth[k], &b = back[k];
    ASSERT_EQ(f.status, b.status);
    ASSERT_EQ(norm(f.normal + b.normal), 0.0) << "pair " << k;
    ASSERT_EQ(f.overlap, b.overlap);
    if (f.status != ContactStatus::touching)
      continue;
    ASSERT_EQ(f.reduced_radius, b.reduced_radius);
    ASSERT_EQ(f.curvature_radius_i, b.curvature_radius_j);
    ASSERT_EQ(f.curvature_radius_j, b.curvature_radius_i);
  }
}

// The overlap is phi at the normal, whatever the normal's own error.
TEST_P(ContactBatchTest, OverlapIsThatAlongTheNormal) {
  const std::vector<Case> cases = make_cases(GetParam(), 20000);
  const std::vector<ContactGeometry> results = solve(cases, ContactBatch::capacity);
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Pair& p = cases[k].pair;
    ASSERT_NEAR(results[k].overlap,
                overlap_along(p.i.shape, p.j.shape, p.centre_distance, results[k].normal),
                1e-14 * norm(p.centre_distance));
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ContactBatchTest,
                         testing::Values(Family::prolate, Family::oblate, Family::triaxial),
                         [](const auto& info) { return name(info.param); });

namespace {

/// Pairs near contact in the plane, bodies with z as any of their axes.
std::vector<Case> make_plane_cases(int count) {
  PairGenerator random(40102);
  const auto body = [&random] {
    Body b;
    b.semiaxes = {random.log_uniform(0.3, 3.0), random.log_uniform(0.3, 3.0),
                  random.log_uniform(0.3, 3.0)};
    b.orientation =
        normalized(Quaternion{random.uniform(-1.0, 1.0), 0.0, 0.0, random.uniform(-1.0, 1.0)});
    b.shape = make_shape(b.semiaxes, b.orientation);
    return b;
  };
  std::vector<Case> cases;
  while (static_cast<int>(cases.size()) < count) {
    Case c{{body(), body(), {}}, {}};
    const double angle = random.uniform(0.0, 6.3), turn = random.log_uniform(1e-8, 0.2);
    const Vector3 normal{std::cos(angle), std::sin(angle), 0.0};
    const auto reach = [&normal](const Body& b) {
      return (1.0 / support(b.shape, normal)) * (b.shape.a_matrix * normal);
    };
    c.pair.centre_distance =
        reach(c.pair.i) + reach(c.pair.j) - random.uniform(-0.01, 0.05) * normal;
    c.start = {std::cos(angle + turn), std::sin(angle + turn), 0.0};
    cases.push_back(c);
  }
  return cases;
}

} // namespace

// Pairs in the plane among themselves, and each with a pair out of the plane: the same numbers.
TEST(ContactBatch, ComputesInThePlaneAsInSpace) {
  const std::vector<Case> in_plane = make_plane_cases(5000);
  const Case out_of_plane = make_cases(Family::triaxial, 1).front();
  std::vector<Case> mixed;
  for (const Case& c : in_plane) {
    mixed.push_back(c);
    mixed.push_back(out_of_plane);
  }
  const std::vector<ContactGeometry> plane = solve(in_plane, ContactBatch::capacity),
                                     space = solve(mixed, ContactBatch::capacity);
  const auto same = [](const Vector3& a, const Vector3& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  };
  int touching = 0;
  for (std::size_t k = 0; k < in_plane.size(); ++k) {
    const ContactGeometry &p = plane[k], &s = space[2 * k];
    ASSERT_EQ(p.status, s.status);
    ASSERT_TRUE(same(p.normal, s.normal)) << "pair " << k;
    ASSERT_EQ(p.normal.z, 0.0);
    if (p.status != ContactStatus::touching)
      continue;
    ++touching;
    ASSERT_TRUE(same(p.point, s.point)) << "pair " << k;
    ASSERT_EQ(p.overlap, s.overlap);
    ASSERT_EQ(p.reduced_radius, s.reduced_radius);
    ASSERT_EQ(p.curvature_radius_i, s.curvature_radius_i);
    ASSERT_EQ(p.curvature_radius_j, s.curvature_radius_j);
    ASSERT_EQ(p.iterations, s.iterations);
  }
  EXPECT_GT(touching, 3000);
}

// Two coinciding bodies, and a start across the line of centres: nothing to trust in the batch.
TEST(ContactBatch, LeavesTroublesomePairsToTheSearchOfSinglePairs) {
  const EllipsoidShape slender = make_shape({20.0, 1.0, 1.0}, Quaternion{});
  const EllipsoidShape crossed =
      make_shape({20.0, 1.0, 1.0}, normalized(Quaternion{1.0, 0.0, 0.0, 1.0}));
  const Vector3 distance{1e-3, 1e-3, 0.2};
  ContactBatch batch;
  batch.add(slender, crossed, distance, {1.0, 0.0, 0.0});
  batch.add(slender, slender, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
  batch.solve();
  EXPECT_TRUE(
      same_bits(batch.geometry(0), find_contact_from({1.0, 0.0, 0.0}, slender, crossed, distance)));
  EXPECT_TRUE(same_bits(batch.geometry(1),
                        find_contact_from({0.0, 1.0, 0.0}, slender, slender, {0.0, 0.0, 0.0})));
}

// The gap is never more than the true distance; after one Newton step from a normal that is off by
// an angle e it is less by the order of e^4, the size of the bodies times 60^2 at aspect 20.
TEST(ContactBatch, FindsGaps) {
  PairGenerator random(40101);
  ContactBatch batch;
  std::vector<double> distances, bounds;
  std::vector<Case> cases;
  int found = 0;
  for (int k = 0; k < 20000; ++k) {
    Case c{random.pair(Family::triaxial, 5.0, 5.0, random.uniform(-0.3, 0.0)), {}};
    SearchOptions exact;
    exact.goal = SearchGoal::distance;
    const ContactGeometry g =
        find_contact(c.pair.i.shape, c.pair.j.shape, c.pair.centre_distance, exact);
    const double angle = random.log_uniform(1e-6, 0.3);
    c.start = normalized(g.normal + angle * random.direction());
    batch.add(c.pair.i.shape, c.pair.j.shape, c.pair.centre_distance, c.start);
    cases.push_back(c);
    distances.push_back(-g.overlap);
    bounds.push_back(1e-13 + 1e3 * std::pow(angle, 4.0));
    if (!batch.full())
      continue;
    batch.find_gaps();
    for (int m = 0; m < batch.size(); ++m) {
      const auto n = static_cast<std::size_t>(m);
      const Pair& p = cases[n].pair;
      const double size = norm(p.centre_distance);
      ASSERT_NEAR(batch.gap(m),
                  -overlap_along(p.i.shape, p.j.shape, p.centre_distance, batch.normal(m)),
                  1e-14 * size);
      ASSERT_NEAR(norm(batch.normal(m)), 1.0, 1e-15);
      ASSERT_LT(batch.gap(m), distances[n] + 1e-14 * size);
      ASSERT_GE(batch.gap(m),
                -overlap_along(p.i.shape, p.j.shape, p.centre_distance, cases[n].start) -
                    1e-14 * size);
      ASSERT_GT(batch.gap(m), distances[n] - bounds[n] * size) << "pair " << m;
      found += batch.gap(m) > 0.0 ? 1 : 0;
    }
    batch.clear();
    cases.clear();
    distances.clear();
    bounds.clear();
  }
  EXPECT_GT(found, 15000);
}

// A lasting contact starts from its own last normal, again and again: no error may grow.
TEST(ContactBatch, StaysExactOverManySteps) {
  const EllipsoidShape i = make_shape({2.0, 1.0, 1.0}, Quaternion{});
  const EllipsoidShape j = make_shape({2.0, 1.0, 1.0}, normalized(Quaternion{1.0, 0.1, 0.3, 0.2}));
  const auto distance = [](int step) {
    return Vector3{0.5 + 1e-7 * std::sin(0.1 * step), 1.6, 0.3};
  };
  constexpr int steps = 10000;
  ContactBatch batch;
  Vector3 normal = find_contact(i, j, distance(0)).normal;
  for (int step = 1; step <= steps; ++step) {
    batch.clear();
    batch.add(i, j, distance(step), normal);
    batch.solve();
    normal = batch.geometry(0).normal;
  }
  const ContactGeometry single = find_contact(i, j, distance(steps));
  ASSERT_EQ(single.status, ContactStatus::touching);
  EXPECT_NEAR(norm(normal), 1.0, 1e-15);
  EXPECT_LT(norm(normal - single.normal), 3e-12);
  EXPECT_NEAR(batch.geometry(0).overlap, single.overlap, 1e-15);
}
