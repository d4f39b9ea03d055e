// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts of any sets of spheres, with each other and with chains, against all pairs of spheres in
// extended precision.
#include "multisphere/motion_batch.h"
#include "multisphere/multisphere_contact.h"
#include "multisphere/near_spheres.h"
#include "random_vectors.h"
#include "sphere_contacts.h"
#include "wall/mesh_contact.h"
#include "wall/plane_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace ellipsoid {
namespace {

using contact_test::Random;

constexpr unsigned seed = 20260603;
using Pairs = std::vector<std::pair<int, int>>;

/// A heap of spheres within an ellipsoid.
SphereSet heap(int count, const Vector3& extent) {
  Random random(seed);
  SphereSet set;
  for (int k = 0; k < count; ++k) {
    const Vector3 p = random.uniform(0.0, 1.0) * normalized(random.vector());
    set.centres.push_back({extent.x * p.x, extent.y * p.y, extent.z * p.z});
    set.radii.push_back(random.uniform(0.1, 0.5));
  }
  return set;
}

/// A disc of equal spheres in a square grid, all centres in the xy plane.
SphereSet disc(int across) {
  SphereSet set;
  const double half = 0.5 * (across - 1);
  for (int k = 0; k < across; ++k)
    for (int l = 0; l < across; ++l)
      if (std::hypot(k - half, l - half) <= half + 0.5) {
        set.centres.push_back({(k - half) / half, (l - half) / half, 0.0});
        set.radii.push_back(0.25);
      }
  return set;
}

struct LongVector {
  long double x, y, z;
};

/// Centres in space by the quaternion itself, v + 2 u x (u x v + w v): no rotation matrix.
std::vector<LongVector> centres_in_space(const std::vector<Vector3>& places, const Quaternion& q,
                                         double scale, const Vector3& centre) {
  const auto cross_with = [&q](const LongVector& v) {
    return LongVector{q.y * v.z - q.z * v.y, q.z * v.x - q.x * v.z, q.x * v.y - q.y * v.x};
  };
  std::vector<LongVector> found;
  for (const Vector3& place : places) {
    const LongVector v{place.x, place.y, place.z}, t = cross_with(v);
    const LongVector u = cross_with({t.x + q.w * v.x, t.y + q.w * v.y, t.z + q.w * v.z});
    found.push_back({scale * (v.x + 2 * u.x) + centre.x, scale * (v.y + 2 * u.y) + centre.y,
                     scale * (v.z + 2 * u.z) + centre.z});
  }
  return found;
}

struct Body {
  MultisphereBody spheres;
  std::vector<Vector3> places;
  std::vector<double> radii;

  explicit Body(const SphereSet& set) : spheres(set), places(set.centres), radii(set.radii) {}
  explicit Body(const MultisphereTemplate& chain) : spheres(chain), radii(chain.radii) {
    for (const double x : chain.centres)
      places.push_back({x, 0.0, 0.0});
  }
  MultispherePose pose(const Quaternion& q, double scale) const {
    MultispherePose found{&spheres, {}, scale};
    turn(found, rotation(q));
    return found;
  }
};

struct Pair {
  const Body &i, &j;
  Quaternion q_i, q_j;
  double scale_j;
  Vector3 distance;

  /// All gaps between spheres, row by row.
  std::vector<long double> gaps() const {
    const auto a = centres_in_space(i.places, q_i, 1.0, {});
    const auto b = centres_in_space(j.places, q_j, scale_j, distance);
    std::vector<long double> found;
    for (std::size_t k = 0; k < a.size(); ++k)
      for (std::size_t l = 0; l < b.size(); ++l)
        found.push_back(std::sqrt((b[l].x - a[k].x) * (b[l].x - a[k].x) +
                                  (b[l].y - a[k].y) * (b[l].y - a[k].y) +
                                  (b[l].z - a[k].z) * (b[l].z - a[k].z)) -
                        i.radii[k] - static_cast<long double>(scale_j) * j.radii[l]);
    return found;
  }
};

/// Pairs whose gap is certainly below the limit, and those for which rounding decides.
struct Truth {
  Pairs certain;
  std::set<std::pair<int, int>> doubtful;
};
Truth closer_than(double limit, const std::vector<long double>& gaps, int columns) {
  constexpr long double rounding = 1e-13L;
  Truth truth;
  for (std::size_t n = 0; n < gaps.size(); ++n) {
    const std::pair<int, int> pair{static_cast<int>(n) / columns, static_cast<int>(n) % columns};
    if (gaps[n] < limit - rounding)
      truth.certain.push_back(pair);
    else if (gaps[n] < limit + rounding)
      truth.doubtful.insert(pair);
  }
  return truth;
}

Pairs without(Pairs pairs, const std::set<std::pair<int, int>>& doubtful) {
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                             [&](const auto& pair) { return doubtful.count(pair) > 0; }),
              pairs.end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// A pose with the bodies a hair apart to a third of a radius overlapping: the distance at which
/// the nearest spheres touch is found by bisection on the brute force.
Pair random_pair(Random& random, const Body& i, const Body& j) {
  Pair pair{i, j, random.orientation(), random.orientation(), random.uniform(0.5, 2.0), {}};
  if (random.uniform(0.0, 1.0) < 0.1)
    pair.q_j = pair.q_i; // planes and axes parallel
  const Vector3 direction = normalized(random.vector());
  const double reach = i.spheres.reach() + pair.scale_j * j.spheres.reach();
  pair.distance = random.uniform(0.3, 1.0) * reach * direction;
  return pair;
}

void compare_with_brute_force(const Body& i, const Body& j, int poses) {
  Random random(seed);
  const int columns = j.spheres.count();
  std::size_t touching = 0, apart = 0;
  for (int n = 0; n < poses; ++n) {
    const Pair pair = random_pair(random, i, j);
    const auto gaps = pair.gaps();
    const long double smallest = *std::min_element(gaps.begin(), gaps.end());
    const MultispherePose pose_i = i.pose(pair.q_i, 1.0), pose_j = j.pose(pair.q_j, pair.scale_j);
    Pairs found;
    for_each_contact(pose_i, pose_j, pair.distance, [&](const SphereContact& c) {
      found.emplace_back(c.sphere_i, c.sphere_j);
      const auto at = static_cast<std::size_t>(c.sphere_i * columns + c.sphere_j);
      EXPECT_NEAR(c.overlap, static_cast<double>(-gaps[at]), 1e-13);
    });
    const Truth truth = closer_than(0.0, gaps, columns);
    ASSERT_EQ(without(found, truth.doubtful), truth.certain) << "pose " << n << ", seed " << seed;
    EXPECT_LE(smallest_gap(pose_i, pose_j, pair.distance), static_cast<double>(smallest) + 1e-13);
    const double limit = std::pow(10.0, random.uniform(-3.0, 0.5));
    int tested = 0;
    EXPECT_NEAR(nearest_gap(pose_i, pose_j, pair.distance, limit, tested),
                std::min(limit, static_cast<double>(smallest)), 1e-9);
    touching += !truth.certain.empty();
    apart += truth.certain.empty();
  }
  EXPECT_GT(touching, static_cast<std::size_t>(poses / 10));
  EXPECT_GT(apart, static_cast<std::size_t>(poses / 10));
}

constexpr int all_poses = 100000;

/// Two bodies that turn and come and go at random.
void expect_contacts_between_searches(const Body& one, const Body& other) {
  Random random(seed);
  NearSpheres near;
  near.restart(1);
  MotionClocks clocks;
  clocks.restart(2);
  MultispherePose poses[2] = {one.pose({}, 1.0), other.pose({}, 1.3)};
  std::array<double, 6> centres{}, last_centres{}, semiaxes{1, 1, 1, 1.3, 1.3, 1.3};
  std::array<double, 8> quaternions{};
  Pair pair{one, other, {}, {}, 1.3, {1.5, 0.0, 0.0}};
  Vector3 velocity, spins[2];
  Quaternion* orientations[2] = {&pair.q_i, &pair.q_j};
  last_centres[3] = 1.5;
  int searches = 0, touching = 0, rests = 0;
  constexpr int steps = 50000;
  std::vector<NearSpheres::Touching> found(1000);
  for (int step = 0; step < steps; ++step) {
    velocity += random.vector(0.3) - 0.1 * velocity -
                0.05 * (norm(pair.distance) - 3.0) * normalized(pair.distance);
    pair.distance += 0.002 * velocity;
    for (int b = 0; b < 2; ++b) {
      spins[b] += random.vector(0.3) - 0.1 * spins[b];
      const Vector3 half = 0.001 * spins[b];
      *orientations[b] = normalized(Quaternion{1.0, half.x, half.y, half.z} * *orientations[b]);
      const Quaternion& q = *orientations[b];
      std::copy_n(std::array<double, 4>{q.w, q.x, q.y, q.z}.begin(), 4, &quaternions[4 * b]);
    }
    centres = {0.0, 0.0, 0.0, pair.distance.x, pair.distance.y, pair.distance.z};
    clocks.advance_all([&](std::size_t, Motions& motions) {
      measure_motions(
          {semiaxes.data(), centres.data(), quaternions.data(), last_centres.data(), poses},
          motions);
    });
    if (near.is_due(0, clocks.time(0), clocks.time(1))) {
      ++searches;
      const auto [gap, tested] = near.search(0, poses[0], poses[1], pair.distance, 0.03);
      near.set_deadlines(0, clocks.deadlines(0, 1, gap, clocks.approach(0, 1)));
    }
    const int count = near.find_touching(0, poses[0], poses[1], pair.distance, found.data());
    Pairs pairs;
    for (int k = 0; k < count; ++k)
      pairs.emplace_back(found[static_cast<std::size_t>(k)].contact.sphere_i,
                         found[static_cast<std::size_t>(k)].contact.sphere_j);
    const Truth truth = closer_than(0.0, pair.gaps(), other.spheres.count());
    ASSERT_EQ(without(pairs, truth.doubtful), truth.certain) << "step " << step;
    touching += !truth.certain.empty();
    rests += near.is_empty(0);
  }
  EXPECT_LT(searches, steps / 2); // the proofs are used
  EXPECT_GT(rests, steps / 100);
  EXPECT_GT(touching, steps / 100); // and tested
}

} // namespace

TEST(ClumpContact, ChainAndChainAsSet) {
  // The same chain once as a chain, once as a set: walk and tree find the same.
  const MultisphereTemplate geometry = make_multisphere(2.35, 1.0, 17);
  SphereSet set;
  for (const double x : geometry.centres)
    set.centres.push_back({x, 0.0, 0.0});
  set.radii = geometry.radii;
  const Body chain(geometry), free(set);
  Random random(seed);
  for (int n = 0; n < all_poses; ++n) {
    const Pair pair = random_pair(random, chain, chain);
    std::vector<SphereContact> walked, searched;
    find_contacts(chain.pose(pair.q_i, 1.0), chain.pose(pair.q_j, pair.scale_j), pair.distance,
                  walked);
    find_contacts(free.pose(pair.q_i, 1.0), free.pose(pair.q_j, pair.scale_j), pair.distance,
                  searched);
    const auto ascending = [](const SphereContact& a, const SphereContact& b) {
      return std::make_pair(a.sphere_i, a.sphere_j) < std::make_pair(b.sphere_i, b.sphere_j);
    };
    std::sort(walked.begin(), walked.end(), ascending);
    std::sort(searched.begin(), searched.end(), ascending);
    ASSERT_EQ(walked.size(), searched.size()) << "pose " << n << ", seed " << seed;
    for (std::size_t k = 0; k < walked.size(); ++k) {
      ASSERT_EQ(walked[k].sphere_i, searched[k].sphere_i);
      ASSERT_EQ(walked[k].sphere_j, searched[k].sphere_j);
      ASSERT_EQ(walked[k].overlap, searched[k].overlap); // bit for bit
      ASSERT_EQ(norm(walked[k].point - searched[k].point), 0.0);
      ASSERT_EQ(norm(walked[k].normal - searched[k].normal), 0.0);
    }
  }
}

TEST(ClumpContact, SetAndSet) {
  const Body one(heap(20, {2.0, 1.0, 0.6})), other(heap(13, {1.0, 1.0, 1.0}));
  compare_with_brute_force(one, other, all_poses);
}

TEST(ClumpContact, ChainAndSet) {
  const Body chain(make_multisphere(3.0, 1.0, 9)), set(heap(20, {1.0, 0.5, 1.5}));
  compare_with_brute_force(chain, set, all_poses / 2);
  compare_with_brute_force(set, chain, all_poses / 2);
}

TEST(ClumpContact, PlanarSets) {
  const Body one(disc(5)), other(disc(4));
  compare_with_brute_force(one, other, all_poses);
}

TEST(ClumpContact, CostIsOfWhatIsNear) {
  // Two plates of 2000 spheres a hair apart: linear in what touches, not 4 million pairs.
  const Body plate(disc(51));
  const MultispherePose pose = plate.pose({}, 1.0);
  int tested = 0;
  EXPECT_GT(plate.spheres.count(), 2000);
  EXPECT_LT(plate.spheres.tree().depth(), largest_tree_depth);
  EXPECT_NEAR(nearest_gap(pose, pose, {0.0, 0.0, 0.501}, 1.0, tested), 0.001, 1e-12);
  EXPECT_LT(tested, 60 * plate.spheres.count());
  std::vector<SphereContact> contacts;
  const ContactCount edge = find_contacts(pose, pose, {2.49, 0.0, 0.0}, contacts);
  EXPECT_GT(edge.contacts, 0);
  EXPECT_LT(edge.tested, 2000);
}

TEST(ClumpContact, LargestTreeIsNotTooDeep) {
  EXPECT_LE(MultisphereBody(heap(largest_set_count, {9.0, 9.0, 9.0})).tree().depth(),
            largest_tree_depth);
}

TEST(ClumpContact, SwappedBodiesSeeTheSame) {
  const Body one(heap(20, {2.0, 1.0, 0.6})), other(make_multisphere(3.0, 1.0, 9));
  Random random(seed);
  for (int n = 0; n < 10000; ++n) {
    const Pair pair = random_pair(random, one, other);
    const MultispherePose i = one.pose(pair.q_i, 1.0), j = other.pose(pair.q_j, pair.scale_j);
    std::vector<SphereContact> there, back;
    find_contacts(i, j, pair.distance, there);
    find_contacts(j, i, -pair.distance, back);
    ASSERT_EQ(there.size(), back.size());
    for (const SphereContact& c : there) {
      const auto same = std::find_if(back.begin(), back.end(), [&c](const SphereContact& d) {
        return d.sphere_i == c.sphere_j && d.sphere_j == c.sphere_i;
      });
      ASSERT_NE(same, back.end());
      ASSERT_EQ(c.overlap, same->overlap);
      ASSERT_EQ(norm(c.normal + same->normal), 0.0);
    }
  }
}

TEST(ClumpContact, NearSpheresHoldEveryContactBetweenSearches) {
  const Body set(heap(20, {2.0, 1.0, 0.6})), plate(disc(4)), chain(make_multisphere(3.0, 1.0, 9));
  expect_contacts_between_searches(set, plate);
  expect_contacts_between_searches(chain, plate);
  expect_contacts_between_searches(set, chain);
}

TEST(ClumpContact, PlaneTouchesWhatReachesIntoIt) {
  const Body body(heap(20, {2.0, 1.0, 0.6}));
  Random random(seed);
  std::size_t touching = 0;
  for (int n = 0; n < 20000; ++n) {
    const Quaternion q = random.orientation();
    const double scale = random.uniform(0.5, 2.0);
    const Vector3 normal = normalized(random.vector());
    const double distance = random.uniform(0.2, 1.1) * scale * body.spheres.reach();
    std::vector<WallContact> contacts;
    find_plane_contacts(body.pose(q, scale), {distance * normal, normal}, contacts);
    const auto centres = centres_in_space(body.places, q, scale, {});
    std::vector<int> truth, found;
    for (std::size_t k = 0; k < centres.size(); ++k) {
      const long double along =
          centres[k].x * normal.x + centres[k].y * normal.y + centres[k].z * normal.z;
      const long double overlap =
          along + scale * static_cast<long double>(body.radii[k]) - distance;
      if (overlap > 1e-13L)
        truth.push_back(static_cast<int>(k));
    }
    for (const WallContact& c : contacts)
      if (c.overlap > 1e-13)
        found.push_back(c.sphere);
    ASSERT_EQ(found, truth);
    touching += truth.size();
  }
  EXPECT_GT(touching, 20000U);
}

TEST(ClumpContact, HollowBodyAstrideAWall) {
  // A horseshoe about a thin wall: its legs are on both sides, its centre of mass on one.
  SphereSet shoe;
  for (int k = 0; k <= 16; ++k) {
    const double angle = M_PI * k / 16.0;
    shoe.centres.push_back({std::cos(angle), std::sin(angle), 0.0});
    shoe.radii.push_back(0.2);
  }
  const Body body(shoe);
  EXPECT_FALSE(body.spheres.is_seen_from_origin(0));
  const std::vector<Triangle> wall = {
      {Vector3{0.3, -9, -9}, Vector3{0.3, -9, 9}, Vector3{0.3, 0.2, 0}}};
  std::vector<TriangleContact> contacts;
  find_mesh_contacts(
      body.pose({}, 1.0), wall, [](int, int) { return true; }, contacts);
  EXPECT_TRUE(contacts.empty()); // no sphere reaches it
}

} // namespace ellipsoid
