// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/near_spheres.h"

#include "chain_motion.h"
#include "random_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ellipsoid {
namespace {

using contact_test::Random;

constexpr unsigned seed = 20100603;
using Pairs = std::vector<std::pair<int, int>>;

MultisphereBody chain(int count) { return MultisphereBody(make_multisphere(2.35, 1.0, count)); }

/// All pairs of spheres closer than `gap`, in ascending order: every one is looked at.
Pairs closer_than(double gap, const MultispherePose& i, const MultispherePose& j,
                  const Vector3& centre_distance) {
  Pairs pairs;
  for (int k = 0; k < i.body->count(); ++k)
    for (int l = 0; l < j.body->count(); ++l) {
      const Vector3 distance = centre_distance + (j.scale * j.body->abscissa(l)) * j.axis -
                               (i.scale * i.body->abscissa(k)) * i.axis;
      if (norm(distance) < i.scale * i.body->radius(k) + j.scale * j.body->radius(l) + gap)
        pairs.emplace_back(k, l);
    }
  return pairs;
}

/// Two bodies that tumble about each other, now touching, now apart.
struct Tumbling {
  Random random{seed};
  MultispherePose i, j;
  Vector3 centre_distance{1.5, 0.0, 0.0}, velocity, spin_i, spin_j;

  Tumbling(const MultisphereBody& chain_i, const MultisphereBody& chain_j) {
    i.body = &chain_i;
    j.body = &chain_j;
    j.scale = 1.3;
  }
  /// @param[in] step length of one step
  void move(double step) {
    velocity += random.vector(0.3) - 0.1 * velocity -
                0.05 * (norm(centre_distance) - 2.4) * normalized(centre_distance);
    spin_i += random.vector(0.3) - 0.1 * spin_i;
    spin_j += random.vector(0.3) - 0.1 * spin_j;
    centre_distance += step * velocity;
    i.axis = normalized(i.axis + step * cross(spin_i, i.axis));
    j.axis = normalized(j.axis + step * cross(spin_j, j.axis));
  }
};

/// Touching pairs among the near spheres, ascending.
Pairs touching_pairs(NearSpheres& near, const Tumbling& bodies) {
  Pairs pairs;
  std::vector<NearSpheres::Touching> touching(
      static_cast<std::size_t>(near.end(1) - near.begin(1)));
  touching.resize(static_cast<std::size_t>(
      near.find_touching(1, bodies.i, bodies.j, bodies.centre_distance, touching.data())));
  for (const NearSpheres::Touching& t : touching) {
    EXPECT_EQ(t.spheres->sphere_i, t.contact.sphere_i);
    EXPECT_EQ(t.spheres->sphere_j, t.contact.sphere_j);
    pairs.emplace_back(t.spheres->sphere_i, t.spheres->sphere_j);
  }
  return pairs;
}

class Watch : public ::testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Watch, FindsWhatIsCloserThanTheGap) {
  const MultisphereBody one = chain(GetParam().first), other = chain(GetParam().second);
  Random random(seed);
  std::size_t all = 0;
  for (int pose = 0; pose < 20000; ++pose) {
    const MultispherePose i{&one, normalized(random.vector(1.0)), 1.0};
    const MultispherePose j{&other, normalized(random.vector(1.0)), random.uniform(0.5, 2.0)};
    const Vector3 distance = random.uniform(1.0, 6.0) * normalized(random.vector(1.0));
    const double gap = std::pow(10.0, random.uniform(-5.0, 0.0));
    const Pairs truth = closer_than(gap, i, j, distance);
    Pairs found;
    for_each_near_pair(i, j, distance, gap, [&](int k, int l, double overlap) {
      if (overlap > -gap)
        found.emplace_back(k, l);
    });
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, truth) << "pose " << pose << ", seed " << seed;
    all += truth.size();
  }
  EXPECT_GT(all, 1000U);
}

TEST_P(Watch, KnowsEveryContactBetweenSearches) {
  const MultisphereBody one = chain(GetParam().first), other = chain(GetParam().second);
  Tumbling bodies(one, other);
  NearSpheres near;
  near.restart(3);
  MotionClocks clocks;
  clocks.restart(2);
  int searches = 0, touching = 0, contacts_begun = 0, rests = 0;
  Pairs before;
  constexpr int steps = 100000;
  for (int step = 0; step < steps; ++step) {
    const Tumbling last = bodies;
    bodies.move(0.002);
    clocks.begin_step();
    clocks.advance(0, motion(last.i, bodies.i, {}));
    clocks.advance(1, motion(last.j, bodies.j, bodies.centre_distance - last.centre_distance));
    if (near.is_due(1, clocks.time(0), clocks.time(1))) {
      ++searches;
      const auto [gap, tested] = near.search(1, bodies.i, bodies.j, bodies.centre_distance, 0.03);
      EXPECT_GE(tested, 0);
      near.set_deadlines(1, clocks.deadlines(0, 1, gap, clocks.approach(0, 1)));
    }
    const Pairs truth = closer_than(0.0, bodies.i, bodies.j, bodies.centre_distance);
    ASSERT_EQ(touching_pairs(near, bodies), truth) << "step " << step << ", seed " << seed;
    touching += !truth.empty();
    contacts_begun += truth != before;
    rests += near.is_empty(1);
    before = truth;
  }
  EXPECT_LT(searches, steps / 2); // the proofs are used
  EXPECT_GT(rests, steps / 100);
  EXPECT_GT(touching, steps / 100); // and tested
  EXPECT_GT(contacts_begun, 100);
}

INSTANTIATE_TEST_SUITE_P(Chains, Watch,
                         ::testing::Values(std::make_pair(1, 1), std::make_pair(3, 3),
                                           std::make_pair(5, 5), std::make_pair(5, 13),
                                           std::make_pair(17, 17), std::make_pair(55, 17)));

TEST(NearSpheres, ForgetsAndStartsDue) {
  const MultisphereBody five = chain(5);
  NearSpheres near;
  near.restart(2);
  EXPECT_TRUE(near.is_due(0, 0.0, 0.0));
  EXPECT_TRUE(near.is_empty(0));
  const MultispherePose pose{&five, {1.0, 0.0, 0.0}, 1.0};
  EXPECT_NEAR(near.search(0, pose, pose, {0.0, 1.9, 0.0}, 0.01).gap, 0.01, 1e-7);
  EXPECT_FALSE(near.is_empty(0));
  EXPECT_TRUE(near.is_due(0, 0.0, 0.0));
  near.set_deadlines(0, {1.0, 2.0});
  EXPECT_FALSE(near.is_due(0, 0.99, 1.99));
  EXPECT_TRUE(near.is_due(0, 1.0, 0.0));
  EXPECT_TRUE(near.is_due(0, 0.0, 2.0));
  EXPECT_TRUE(near.is_due(1, 0.0, 0.0));
  // 1 between the capsules
  EXPECT_NEAR(near.search(1, pose, pose, {0.0, 3.0, 0.0}, 0.01).gap, 1.0, 1e-5);
  EXPECT_TRUE(near.is_empty(1));
  near.restart(2);
  EXPECT_TRUE(near.is_due(0, 0.0, 0.0));
  EXPECT_TRUE(near.is_empty(0));
}

TEST(NearSpheres, MotionBoundsEverySphere) {
  const MultisphereBody nine = chain(9);
  Random random(seed);
  for (int pose = 0; pose < 10000; ++pose) {
    const MultispherePose before{&nine, normalized(random.vector(1.0)), 1.0};
    const MultispherePose after{&nine, normalized(before.axis + random.vector(0.3)),
                                random.uniform(0.9, 1.1)};
    const Vector3 displacement = random.vector(0.5);
    for (int k = 0; k < nine.count(); ++k) {
      const Vector3 way = displacement + (after.scale * nine.abscissa(k)) * after.axis -
                          (before.scale * nine.abscissa(k)) * before.axis;
      const double grown = std::fabs(after.scale - before.scale) * nine.radius(k);
      const Motion bound = motion(before, after, displacement);
      EXPECT_LE(norm(way - bound.displacement) + grown, bound.turn * (1.0 + 1e-14) + 1e-15);
    }
  }
}

} // namespace
} // namespace ellipsoid
