// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Collisions found in frames: one Hertz collision, spinning bodies, pairs that never part.
#include "collisions.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace ellipsoid::post {
namespace {

constexpr double radius = 0.01, mass = 0.02, modulus = 1e7, speed = 0.3;
const PeriodicCell cell({0.0, 0.0, 0.0},
                        {Vector3{0.1, 0.0, 0.0}, Vector3{0.0, 0.1, 0.0}, Vector3{0.0, 0.0, 0.1}},
                        {true, true, true});

/// Two balls on the x axis with their centres this far apart, one of them beyond the boundary.
ParticleSet pair(double distance, double approach) {
  ParticleSet set;
  set.has_velocities = set.has_spins = true;
  std::fill(set.box.upper, set.box.upper + 3, 0.1);
  set.box.boundary = "pp pp pp";
  for (int k = 0; k < 2; ++k) {
    Particle p;
    p.id = 5 + k;
    p.mass = mass;
    p.semiaxes = {radius, radius, radius};
    const double sign = k == 0 ? -1.0 : 1.0;
    p.centre = cell.wrapped({sign * 0.5 * distance, 0.05, 0.05});
    p.velocity = {-sign * 0.5 * approach, 0.2, 0.0};
    set.particles.push_back(p);
  }
  return set;
}

/// The next frame, with the contacts that its positions have.
std::vector<Collision> following(Collisions& collisions, const ParticleSet& set, double time) {
  return collisions.advance(set, touching_pairs(set), time);
}

TEST(Collisions, one_hertz_collision) {
  const double effective_mass = 0.5 * mass, effective_radius = 0.5 * radius;
  // Johnson 1985, section 11.4: 2.94 delta / v, delta = (15 m v^2 / (16 sqrt(R) E))^(2/5)
  const double depth = std::pow(
      15.0 * effective_mass * speed * speed / (16.0 * std::sqrt(effective_radius) * modulus), 0.4);
  const double duration = 2.9432752 * depth / speed, frame = duration / 100.0;
  double distance = 2.0 * radius + 7.5 * frame * speed, approach = speed, time = 0.0;
  Collisions collisions;
  std::vector<Collision> found;
  for (int n = 0; n < 130; ++n) {
    for (const Collision& c : following(collisions, pair(distance, approach), time))
      found.push_back(c);
    constexpr int steps = 400; // of the engine between two frames
    for (int k = 0; k < steps; ++k) {
      const double h = frame / steps;
      distance -= 0.5 * h * approach;
      const double overlap = std::max(0.0, 2.0 * radius - distance);
      approach -= h * 4.0 / 3.0 * modulus * std::sqrt(effective_radius) * std::pow(overlap, 1.5) /
                  effective_mass;
      distance -= 0.5 * h * approach;
    }
    time += frame;
  }
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id_1, 5);
  EXPECT_EQ(found[0].id_2, 6);
  EXPECT_NEAR(found[0].normal_speed, speed, 1e-9);
  EXPECT_NEAR(found[0].tangential_speed, 0.0, 1e-9); // both move along y together
  EXPECT_NEAR(found[0].departure_speed, speed, 1e-4 * speed);
  EXPECT_NEAR(found[0].begin, 7.5 * frame, 0.51 * frame);
  EXPECT_NEAR(found[0].end - found[0].begin, duration, 1.01 * frame); // half of one at either end
  EXPECT_NEAR(found[0].largest_overlap, depth, 1e-3 * depth);
  EXPECT_EQ(collisions.not_ended(), 0u);
  EXPECT_EQ(collisions.from_the_start(), 0u);
}

TEST(Collisions, spins_move_the_point_of_contact) {
  Collisions collisions;
  ParticleSet before = pair(2.1 * radius, speed), after = pair(1.99 * radius, speed);
  for (ParticleSet* set : {&before, &after}) {
    set->particles[0].angular_velocity = {0.0, 0.0, 20.0};
    set->particles[1].angular_velocity = {0.0, 0.0, 30.0};
  }
  following(collisions, before, 0.0);
  EXPECT_TRUE(following(collisions, after, 1.0).empty());
  EXPECT_EQ(collisions.not_ended(), 1u);
  const std::vector<Collision> found = following(collisions, pair(2.1 * radius, -speed), 2.0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].tangential_speed, 50.0 * 0.995 * radius, 1e-9);
  EXPECT_EQ(found[0].begin, 0.5);
  EXPECT_EQ(found[0].end, 1.5);
}

TEST(Collisions, pairs_from_the_start_are_counted_but_are_none) {
  Collisions collisions;
  following(collisions, pair(1.99 * radius, 0.0), 0.0);
  EXPECT_EQ(collisions.from_the_start(), 1u);
  EXPECT_TRUE(following(collisions, pair(2.1 * radius, -speed), 1.0).empty());
  ParticleSet still = pair(2.1 * radius, 0.0);
  still.has_velocities = false;
  EXPECT_THROW(following(collisions, still, 2.0), InputError);
}

} // namespace
} // namespace ellipsoid::post
