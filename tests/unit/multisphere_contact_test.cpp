// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/multisphere_contact.h"
#include "sphere_contacts.h"
#include "wall/plane_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ellipsoid {
namespace {

constexpr unsigned seed = 20100603;

struct LongVector {
  long double x = 0.0L, y = 0.0L, z = 0.0L;
};
LongVector wide(const Vector3& v) { return {v.x, v.y, v.z}; }
LongVector operator+(LongVector a, LongVector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
LongVector operator-(LongVector a, LongVector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
LongVector operator*(long double s, LongVector a) { return {s * a.x, s * a.y, s * a.z}; }
LongVector cross(LongVector a, LongVector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
long double length(LongVector a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

/// Force on i and torques about both centres under the law |F| = overlap (unit stiffness).
struct Loads {
  int contacts = 0;
  LongVector force_on_i, torque_i, torque_j;
};

void add(Loads& loads, LongVector force_on_i, LongVector point, LongVector centre_distance) {
  ++loads.contacts;
  loads.force_on_i = loads.force_on_i + force_on_i;
  loads.torque_i = loads.torque_i + cross(point, force_on_i);
  loads.torque_j = loads.torque_j - cross(point - centre_distance, force_on_i);
}

/// Every sphere of i with every sphere of j, in extended precision, with its own formulas.
Loads brute_force(const MultispherePose& i, const MultispherePose& j,
                  const Vector3& centre_distance) {
  Loads loads;
  const LongVector d = wide(centre_distance);
  for (int k = 0; k < i.body->count(); ++k)
    for (int l = 0; l < j.body->count(); ++l) {
      const LongVector ck = (1.0L * i.scale * i.body->abscissa(k)) * wide(i.axis);
      const LongVector cl = d + (1.0L * j.scale * j.body->abscissa(l)) * wide(j.axis);
      const long double rk = 1.0L * i.scale * i.body->radius(k);
      const long double rl = 1.0L * j.scale * j.body->radius(l);
      const long double gap = length(cl - ck) - rk - rl;
      if (gap >= 0.0L)
        continue;
      const LongVector n = (1.0L / length(cl - ck)) * (cl - ck);
      add(loads, gap * n, ck + (rk + 0.5L * gap) * n, d);
    }
  return loads;
}

Loads searched(const MultispherePose& i, const MultispherePose& j, const Vector3& centre_distance) {
  Loads loads;
  for_each_contact(i, j, centre_distance, [&](const SphereContact& c) {
    add(loads, -c.overlap * wide(c.normal), wide(c.point), wide(centre_distance));
  });
  return loads;
}

class Poses {
 public:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vector3 direction() {
    std::normal_distribution<double> normal;
    return normalized(Vector3{normal(engine_), normal(engine_), normal(engine_)});
  }
  /// Random, or one of the special poses: parallel, antiparallel, nearly parallel, perpendicular.
  Vector3 second_axis(const Vector3& first) {
    const double choice = uniform(0.0, 1.0);
    if (choice < 0.04)
      return first;
    if (choice < 0.06)
      return -first;
    if (choice < 0.12) {
      const double angle = std::pow(10.0, uniform(-10.0, -1.0));
      return normalized(first + angle * direction());
    }
    if (choice < 0.16)
      return normalized(cross(first, direction()));
    return direction();
  }
  /// Random, or along or across one of the axes (end to end, tip on flank, side by side).
  Vector3 centre_direction(const Vector3& axis_i, const Vector3& axis_j) {
    const double choice = uniform(0.0, 1.0);
    if (choice < 0.04)
      return axis_i;
    if (choice < 0.08)
      return -axis_j;
    if (choice < 0.12)
      return normalized(cross(axis_i, direction()));
    return direction();
  }

 private:
  std::mt19937_64 engine_{seed};
};

/// Largest distance along `direction` at which any two spheres touch; 0 if there is none.
double touching_distance(const MultispherePose& i, const MultispherePose& j,
                         const Vector3& direction) {
  double largest = 0.0;
  for (int k = 0; k < i.body->count(); ++k)
    for (int l = 0; l < j.body->count(); ++l) {
      const Vector3 offset =
          (j.scale * j.body->abscissa(l)) * j.axis - (i.scale * i.body->abscissa(k)) * i.axis;
      const double sum = i.scale * i.body->radius(k) + j.scale * j.body->radius(l);
      const double along = dot(offset, direction);
      const double discriminant = along * along - dot(offset, offset) + sum * sum;
      if (discriminant > 0.0)
        largest = std::fmax(largest, std::sqrt(discriminant) - along);
    }
  return largest;
}

struct Pair {
  MultispherePose i, j;
  Vector3 centre_distance;
};

/// A pair in a random pose, from a hair apart to overlapping by a third of the smaller minor axis.
Pair random_pair(Poses& poses, const MultisphereBody& chain_i, const MultisphereBody& chain_j,
                 double largest_ratio) {
  Pair pair;
  pair.i.body = &chain_i;
  pair.j.body = &chain_j;
  const double ratio = std::pow(largest_ratio, poses.uniform(-1.0, 1.0));
  (ratio > 1.0 ? pair.i : pair.j).scale = ratio > 1.0 ? ratio : 1.0 / ratio;
  pair.i.axis = poses.direction();
  pair.j.axis = poses.second_axis(pair.i.axis);
  const Vector3 direction = poses.centre_direction(pair.i.axis, pair.j.axis);
  const double smaller =
      std::fmin(pair.i.scale * chain_i.largest_radius(), pair.j.scale * chain_j.largest_radius());
  const double overlap = poses.uniform(0.0, 1.0) < 0.1
                             ? -0.01 * smaller
                             : smaller / 3.0 * std::pow(10.0, poses.uniform(-6.0, 0.0));
  pair.centre_distance = (touching_distance(pair.i, pair.j, direction) - overlap) * direction;
  return pair;
}

MultisphereBody chain(double aspect_ratio, int count,
                      SphereSpacing spacing = SphereSpacing::paper) {
  return MultisphereBody(make_multisphere(aspect_ratio, 1.0, count, spacing));
}

void expect_equal(const Loads& found, const Loads& truth, double size) {
  // Overlaps are differences of lengths of the pair's size: so is their rounding.
  const double tolerance = 1e-13 * size * std::max(1, truth.contacts);
  ASSERT_EQ(found.contacts, truth.contacts);
  EXPECT_LE(length(found.force_on_i - truth.force_on_i), tolerance);
  EXPECT_LE(length(found.torque_i - truth.torque_i), tolerance * size);
  EXPECT_LE(length(found.torque_j - truth.torque_j), tolerance * size);
}

double size_of(const Pair& pair) {
  return pair.i.scale * (pair.i.body->half_length() + pair.i.body->largest_radius()) +
         pair.j.scale * (pair.j.body->half_length() + pair.j.body->largest_radius());
}

void compare_with_brute_force(const MultisphereBody& i, const MultisphereBody& j,
                              double largest_ratio, int poses_count) {
  Poses poses;
  int touching = 0;
  for (int pose = 0; pose < poses_count; ++pose) {
    const Pair pair = random_pair(poses, i, j, largest_ratio);
    const Loads truth = brute_force(pair.i, pair.j, pair.centre_distance);
    expect_equal(searched(pair.i, pair.j, pair.centre_distance), truth, size_of(pair));
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "pose " << pose << ", seed " << seed;
    if (truth.contacts == 0)
      continue;
    ++touching;
    EXPECT_LE(smallest_gap(pair.i, pair.j, pair.centre_distance), 0.0);
  }
  EXPECT_GT(touching, poses_count / 2); // the poses do test contact
}

class BruteForce : public ::testing::TestWithParam<int> {};

TEST_P(BruteForce, HundredThousandPoses) {
  const MultisphereBody one = chain(2.35, GetParam());
  compare_with_brute_force(one, one, 1.0, 100000);
}

INSTANTIATE_TEST_SUITE_P(MultisphereContact, BruteForce, ::testing::Values(1, 3, 5, 17, 55));

TEST(MultisphereContact, MixedCountsSizesShapesAndSpacings) {
  const MultisphereBody ball = chain(1.2, 1), three = chain(2.9, 3), short_chain = chain(1.01, 9);
  const MultisphereBody middle = chain(2.35, 17, SphereSpacing::minimax_outline);
  const MultisphereBody needle = chain(10.0, 55), coarse = chain(10.0, 23);
  const MultisphereBody area = chain(5.0, 13, SphereSpacing::minimax_area);
  const MultisphereBody* chains[] = {&ball, &three, &short_chain, &middle, &needle, &coarse, &area};
  for (const MultisphereBody* i : chains)
    for (const MultisphereBody* j : chains)
      compare_with_brute_force(*i, *j, 100.0, 2500);
}

TEST(MultisphereContact, SwapSymmetryAndReaction) {
  const MultisphereBody a = chain(2.35, 17), b = chain(5.0, 33);
  Poses poses;
  std::vector<SphereContact> forth, back;
  for (int pose = 0; pose < 20000; ++pose) {
    const Pair pair = random_pair(poses, a, pose % 2 ? a : b, 10.0);
    find_contacts(pair.i, pair.j, pair.centre_distance, forth);
    find_contacts(pair.j, pair.i, -pair.centre_distance, back);
    ASSERT_EQ(forth.size(), back.size());
    std::sort(back.begin(), back.end(), [](const SphereContact& p, const SphereContact& q) {
      return std::make_pair(p.sphere_j, p.sphere_i) < std::make_pair(q.sphere_j, q.sphere_i);
    });
    std::sort(forth.begin(), forth.end(), [](const SphereContact& p, const SphereContact& q) {
      return std::make_pair(p.sphere_i, p.sphere_j) < std::make_pair(q.sphere_i, q.sphere_j);
    });
    for (std::size_t n = 0; n < forth.size(); ++n) {
      const SphereContact &f = forth[n], &g = back[n];
      ASSERT_EQ(f.sphere_i, g.sphere_j);
      ASSERT_EQ(f.sphere_j, g.sphere_i);
      EXPECT_EQ(norm(f.normal + g.normal), 0.0);
      EXPECT_EQ(f.overlap, g.overlap);
      EXPECT_EQ(f.reduced_radius, g.reduced_radius);
      EXPECT_EQ(f.radius_i, g.radius_j);
      EXPECT_LE(norm(f.point - (pair.centre_distance + g.point)), 1e-14 * size_of(pair));
    }
    // Angular momentum: T_i + T_j + d x F_j = 0 with F_j = -F_i.
    const Loads loads = searched(pair.i, pair.j, pair.centre_distance);
    const LongVector balance =
        loads.torque_i + loads.torque_j - cross(wide(pair.centre_distance), loads.force_on_i);
    EXPECT_LE(length(balance), 1e-15 * size_of(pair) * size_of(pair));
  }
}

TEST(MultisphereContact, ContactGeometry) {
  const MultisphereBody a = chain(2.35, 17);
  Poses poses;
  for (int pose = 0; pose < 2000; ++pose) {
    const Pair pair = random_pair(poses, a, a, 3.0);
    for_each_contact(pair.i, pair.j, pair.centre_distance, [&](const SphereContact& c) {
      const double size = size_of(pair);
      const Vector3 ck = (pair.i.scale * a.abscissa(c.sphere_i)) * pair.i.axis;
      const Vector3 cl =
          pair.centre_distance + (pair.j.scale * a.abscissa(c.sphere_j)) * pair.j.axis;
      EXPECT_NEAR(norm(c.normal), 1.0, 1e-15);
      EXPECT_GT(dot(c.normal, cl - ck), 0.0);
      EXPECT_GT(c.overlap, 0.0);
      // Moved apart by the overlap along the normal, the two spheres just touch.
      EXPECT_NEAR(norm(cl + c.overlap * c.normal - ck), c.radius_i + c.radius_j, 1e-14 * size);
      // The point lies half an overlap below both surfaces.
      EXPECT_NEAR(norm(c.point - ck), c.radius_i - 0.5 * c.overlap, 1e-14 * size);
      EXPECT_NEAR(norm(c.point - cl), c.radius_j - 0.5 * c.overlap, 1e-14 * size);
      EXPECT_NEAR(c.reduced_radius, 1.0 / (1.0 / c.radius_i + 1.0 / c.radius_j), 1e-14 * size);
    });
  }
}

TEST(MultisphereContact, OneSphereIsASphere) {
  const MultisphereBody ball = chain(2.0, 1);
  const MultispherePose i{&ball, {0.0, 0.6, 0.8}, 2.0}, j{&ball, {1.0, 0.0, 0.0}, 0.5};
  std::vector<SphereContact> contacts;
  ContactCount count = find_contacts(i, j, {0.0, 2.4, 0.0}, contacts);
  ASSERT_EQ(count.contacts, 1);
  EXPECT_GE(count.tested, 1);
  EXPECT_NEAR(contacts[0].overlap, 0.1, 1e-15);
  EXPECT_NEAR(norm(contacts[0].normal - Vector3{0.0, 1.0, 0.0}), 0.0, 1e-15);
  EXPECT_NEAR(norm(contacts[0].point - Vector3{0.0, 1.95, 0.0}), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(contacts[0].reduced_radius, 2.0 * 0.5 / 2.5);
  EXPECT_EQ(find_contacts(i, j, {0.0, 2.5, 0.0}, contacts).contacts, 0); // just touching
  EXPECT_EQ(find_contacts(i, j, {0.0, 0.0, 0.0}, contacts).contacts, 1); // same centre
  EXPECT_EQ(contacts[0].overlap, 2.5);
  EXPECT_NEAR(norm(contacts[0].normal), 1.0, 1e-15);
}

TEST(MultisphereContact, SideBySideEndToEndAndCrossed) {
  const MultisphereBody c = chain(2.35, 17);
  const Vector3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0};
  std::vector<SphereContact> contacts;
  // Parallel, side by side: the centre spheres first, then every sphere with its own partner.
  ASSERT_EQ(find_contacts({&c, x, 1.0}, {&c, x, 1.0}, 1.999 * y, contacts).contacts, 1);
  EXPECT_EQ(contacts[0].sphere_i, 8);
  EXPECT_EQ(contacts[0].sphere_j, 8);
  find_contacts({&c, x, 1.0}, {&c, x, 1.0}, 0.8 * y, contacts);
  for (int k = 0; k < 17; ++k)
    EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(), [k](const SphereContact& contact) {
      return contact.sphere_i == k && contact.sphere_j == k;
    }));
  // End to end, same and opposite direction.
  ASSERT_EQ(find_contacts({&c, x, 1.0}, {&c, x, 1.0}, 4.699 * x, contacts).contacts, 1);
  EXPECT_EQ(contacts[0].sphere_i, 16);
  EXPECT_EQ(contacts[0].sphere_j, 0);
  ASSERT_EQ(find_contacts({&c, x, 1.0}, {&c, -x, 1.0}, 4.699 * x, contacts).contacts, 1);
  EXPECT_EQ(contacts[0].sphere_j, 16);
  // Crossed with meeting axes: a deep overlap.
  EXPECT_GT(find_contacts({&c, x, 1.0}, {&c, y, 1.0}, {0.0, 0.0, 0.0}, contacts).contacts, 100);
  // Far away: nothing is tested.
  EXPECT_EQ(find_contacts({&c, x, 1.0}, {&c, y, 1.0}, {9.0, 0.0, 0.0}, contacts).tested, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(find_contacts({&c, x, 1.0}, {&c, y, 1.0}, {nan, 0.0, 0.0}, contacts).contacts, 0);
  EXPECT_EQ(find_contacts({&c, {nan, 0., 0.}, 1.0}, {&c, y, 1.0}, 1.9 * x, contacts).contacts, 0);
}

TEST(MultisphereContact, TestsOrderOfNPairs) {
  // Light contact, as in a pile.
  for (const int count : {5, 17, 55}) {
    const MultisphereBody c = chain(2.35, count);
    Poses poses;
    long tested = 0;
    constexpr int poses_count = 5000;
    for (int pose = 0; pose < poses_count; ++pose) {
      MultispherePose i{&c, poses.direction(), 1.0}, j{&c, poses.direction(), 1.0};
      const Vector3 direction = poses.direction();
      const Vector3 d = (touching_distance(i, j, direction) - 1e-3) * direction;
      tested += for_each_contact(i, j, d, [](const SphereContact&) {}).tested;
    }
    const double mean = static_cast<double>(tested) / poses_count;
    RecordProperty("tested_per_pair_" + std::to_string(count), std::to_string(mean));
    EXPECT_LT(mean, 2.0 * count);
  }
}

TEST(MultisphereContact, EveryTemplateIsConcave) {
  for (const double s : {1.05, 1.5, 2.35, 2.99, 5.0, 10.0, 20.0})
    for (const int count : {1, 3, 5, 7, 9, 13, 17, 23, 33, 47, 55})
      for (const SphereSpacing spacing :
           {SphereSpacing::paper, SphereSpacing::minimax_outline, SphereSpacing::minimax_area}) {
        const int smallest = smallest_overlapping_count(s, spacing);
        if (count > 1 && count < smallest)
          continue;
        EXPECT_NO_THROW(chain(s, count, spacing)) << s << " " << count << " " << word_of(spacing);
      }
}

TEST(MultisphereContact, PlaneAgainstEverySphere) {
  const MultisphereBody c = chain(2.35, 17);
  Poses poses;
  std::vector<WallContact> contacts;
  for (int pose = 0; pose < 20000; ++pose) {
    const MultispherePose i{&c, poses.direction(), poses.uniform(0.1, 10.0)};
    const Vector3 n = poses.direction();
    double reach = 0.0;
    for (int k = 0; k < c.count(); ++k)
      reach = std::fmax(reach, i.scale * (c.radius(k) + c.abscissa(k) * dot(i.axis, n)));
    const double depth =
        i.scale * (pose % 10 == 0 ? -1e-9 : std::pow(10.0, poses.uniform(-6., -0.3)));
    const Vector3 along = cross(n, poses.direction()); // any point of the plane will do
    const Vector3 point = (reach - depth) * n + 7.0 * along;
    find_plane_contacts(i, {point, n}, contacts);
    const int found = static_cast<int>(contacts.size());
    EXPECT_EQ(found > 0, depth > 0.0);
    int expected = 0;
    for (int k = 0; k < c.count(); ++k) {
      const Vector3 centre = (i.scale * c.abscissa(k)) * i.axis;
      const double overlap = i.scale * c.radius(k) + dot(centre - point, n);
      if (overlap <= 1e-14 * i.scale)
        continue;
      ASSERT_LT(expected, found);
      const WallContact& contact = contacts[static_cast<std::size_t>(expected++)];
      EXPECT_EQ(contact.sphere, k);
      EXPECT_EQ(contact.triangle, -1);
      EXPECT_NEAR(contact.overlap, overlap, 1e-13 * i.scale);
      EXPECT_EQ(contact.reduced_radius, i.scale * c.radius(k));
      const Vector3 lowest = centre + (i.scale * c.radius(k)) * n;
      EXPECT_LE(norm(contact.point - (lowest - 0.5 * overlap * n)), 1e-13 * i.scale);
      EXPECT_LE(norm(contact.foot - (lowest - overlap * n)), 1e-13 * i.scale);
    }
    EXPECT_EQ(expected, found);
  }
}

TEST(MultisphereContact, GapBoundAgainstSampledCapsules) {
  const MultisphereBody a = chain(2.35, 17), b = chain(10.0, 55);
  Poses poses;
  for (int pose = 0; pose < 2000; ++pose) {
    const Vector3 u = poses.direction();
    const MultispherePose i{&a, u, poses.uniform(0.1, 10.0)}, j{&b, poses.second_axis(u), 1.0};
    const Vector3 d = poses.uniform(0.0, 30.0) * poses.centre_direction(i.axis, j.axis);
    const double half_i = i.scale * a.half_length(), half_j = b.half_length();
    double nearest = 1e300;
    for (int n = 0; n <= 200; ++n) {
      const double x = half_i * (0.01 * n - 1.0);
      // Exact nearest point of the other segment.
      const double y = std::clamp(dot(x * i.axis - d, j.axis), -half_j, half_j);
      nearest = std::fmin(nearest, norm(d + y * j.axis - x * i.axis));
    }
    const double gap = smallest_gap(i, j, d) + i.scale * a.largest_radius() + b.largest_radius();
    // Where nearly parallel axes meet, the nearest points are known to the root of rounding only.
    const double tolerance = nearest < 0.01 ? 1e-7 * (half_i + half_j) : 0.0;
    EXPECT_LE(gap, nearest + tolerance);
    EXPECT_GE(gap, nearest - 0.005 * half_i - 1e-9); // half a sampling step
  }
}

TEST(MultisphereContact, MulticontactWeight) {
  EXPECT_EQ(multicontact_weight(MulticontactRule::sum, 4), 1.0);
  EXPECT_EQ(multicontact_weight(MulticontactRule::average, 4), 0.25);
  EXPECT_EQ(multicontact_weight(MulticontactRule::average, 1), 1.0);
}

TEST(MultisphereContact, RefusesBadChains) {
  const auto refused = [](std::vector<double> centres, std::vector<double> radii) {
    EXPECT_THROW(MultisphereBody(MultisphereTemplate{2.0, 1.0, SphereSpacing::paper,
                                                     std::move(centres), std::move(radii)}),
                 std::invalid_argument);
  };
  refused({}, {});
  refused({0.0}, {1.0, 2.0});
  refused({0.0, 0.0}, {1.0, 1.0});
  refused({0.0}, {0.0});
  refused({0.0}, {std::nan("")});
  refused({-1.0, 0.0, 1.0}, {1.0, 0.5, 1.0}); // a waist
}

} // namespace
} // namespace ellipsoid
