// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Ways, rotations and flows of made trajectories.
#include "flow_through.h"
#include "trajectories.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace ellipsoid::post {
namespace {

const PeriodicCell tilted({0.0, 0.0, 0.0},
                          {Vector3{1.0, 0.0, 0.0}, Vector3{0.3, 1.0, 0.0}, Vector3{0.0, -0.2, 1.0}},
                          {true, true, true});

Quaternion turn_about(const Vector3& axis, double angle) {
  const Vector3 n = std::sin(0.5 * angle) * normalized(axis);
  return {std::cos(0.5 * angle), n.x, n.y, n.z};
}

/// Free flight: particle k moves with velocity v_k and spins with omega_k.
ParticleSet flight(double time, int count) {
  ParticleSet set;
  for (int k = 0; k < count; ++k) {
    Particle p;
    p.id = 10 + 3 * k;
    p.mass = 2.0;
    p.semiaxes = {0.1, 0.3, 0.1};
    const Vector3 velocity{0.5 + 0.1 * k, -0.3, 0.2 * k};
    const Vector3 spin{0.0, 0.4 + 0.2 * k, 1.0};
    p.centre = tilted.wrapped(Vector3{0.1 * k, 0.2, 0.3} + time * velocity);
    p.orientation = turn_about(spin, norm(spin) * time) * turn_about({1.0, 2.0, 3.0}, 0.7 * k);
    set.particles.push_back(p);
  }
  return set;
}

TEST(Trajectories, free_flight_and_spin) {
  constexpr int count = 4, frames = 40;
  constexpr double step = 0.1;
  Trajectories one(1, 1), many(10, 3);
  for (int n = 0; n < frames; ++n) {
    one.add(flight(step * n, count), tilted);
    many.add(flight(step * n, count), tilted);
  }
  for (const std::size_t lag : {std::size_t{0}, std::size_t{7}, std::size_t{39}}) {
    const double t = step * static_cast<double>(lag);
    double msd_x = 0.0, msd_z = 0.0, rotation = 0.0;
    for (int k = 0; k < count; ++k) {
      msd_x += std::pow((0.5 + 0.1 * k) * t, 2) / count;
      msd_z += std::pow(0.2 * k * t, 2) / count;
      rotation += (std::pow(0.4 + 0.2 * k, 2) + 1.0) * t * t / count;
    }
    for (const Trajectories* each : {&one, &many}) {
      const LagMeans m = each->means(lag);
      EXPECT_NEAR(m.squared_displacement.x, msd_x, 1e-10);
      EXPECT_NEAR(m.squared_displacement.y, 0.09 * t * t, 1e-10);
      EXPECT_NEAR(m.squared_displacement.z, msd_z, 1e-10);
      EXPECT_NEAR(m.displacement.y, -0.3 * t, 1e-10);
      EXPECT_NEAR(m.squared_rotation, rotation, 1e-10);
    }
    EXPECT_EQ(one.means(lag).pairs, 4u);
  }
  EXPECT_EQ(many.means(7).pairs, 40u); // origins 0, 3, .. 27 have a frame 7 later
  EXPECT_EQ(many.means(39).pairs, 4u);
  EXPECT_NEAR(one.means(0).direction_p2, 1.0, 1e-12);
  EXPECT_NEAR(one.way(13).z, 0.2 * 3.9, 1e-10);
}

TEST(Trajectories, the_long_axis_forgets_its_direction_as_it_turns) {
  Trajectories one(1, 1);
  for (int n = 0; n < 10; ++n) {
    ParticleSet set = flight(0.0, 1);
    set.particles[0].orientation = turn_about({0.0, 0.0, 1.0}, 0.2 * n); // long axis: y
    one.add(set, tilted);
  }
  EXPECT_NEAR(one.means(9).direction, std::cos(1.8), 1e-12);
  EXPECT_NEAR(one.means(9).direction_p2, 1.5 * std::pow(std::cos(1.8), 2) - 0.5, 1e-12);
}

TEST(Trajectories, particles_that_were_away_begin_anew) {
  Trajectories one(1, 1);
  one.add(flight(0.0, 2), tilted);
  one.add(flight(0.1, 1), tilted);
  one.add(flight(0.2, 2), tilted);
  EXPECT_EQ(one.means(1).pairs, 1u);
  EXPECT_NEAR(norm(one.way(13)), 0.0, 1e-12);
}

/// One particle that creeps along x in a box that repeats and is sheared and stretched.
TEST(Trajectories, unwrapped_images_far_from_the_box_go_the_way_of_the_one_in_it) {
  for (const int images : {0, 3, -2}) { // how many edges along y the file's image lies away
    Trajectories wrapped(1, 1), unwrapped(1, 1);
    for (int n = 0; n < 6; ++n) {
      const Vector3 sheared{0.1 * n, 1.0 + 0.05 * n, 0.0};
      const PeriodicCell cell({0.0, 0.0, 0.0}, {Vector3{1.0, 0.0, 0.0}, sheared, {0.0, 0.0, 1.0}},
                              {true, true, true});
      ParticleSet set = flight(0.0, 1);
      set.particles[0].centre = Vector3{0.3 + 0.07 * n, 0.5, 0.5};
      wrapped.add(set, cell);
      set.particles[0].unwrapped_centre = set.particles[0].centre + double(images) * sheared;
      set.tells_ways = true;
      unwrapped.add(set, cell);
    }
    EXPECT_NEAR(wrapped.way(10).x, 0.35, 1e-12);
    EXPECT_NEAR(norm(unwrapped.way(10) - wrapped.way(10)), 0.0, 1e-12) << images;
    EXPECT_EQ(unwrapped.long_steps().doubtful + unwrapped.long_steps().by_flags, 0u);
  }
}

TEST(Flow, shares_of_bodies_beyond_a_plane) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  ParticleSet set;
  Particle smooth;
  smooth.semiaxes = {0.5, 0.2, 0.3};
  smooth.orientation = normalized(Quaternion{0.2, 0.5, -0.3, 0.6});
  Particle bent;
  bent.semiaxes = {0.3, 0.3, 0.3};
  bent.centre = {0.1, 0.0, 0.05};
  bent.sphere_count = 3;
  set.spheres = {{{0.0, 0.0, 0.0}, 0.2}, {{0.2, 0.0, 0.0}, 0.15}, {{0.0, 0.05, 0.2}, 0.12}};
  set.particles = {smooth, bent};
  const Vector3 normal = normalized(Vector3{1.0, 2.0, -0.5}), point{0.05, 0.02, 0.0};
  for (const Particle& p : set.particles) {
    int inside = 0, beyond = 0;
    for (int trial = 0; trial < 400000; ++trial) {
      const Vector3 r = p.centre + 0.55 * Vector3{any(generator), any(generator), any(generator)};
      bool is_in = false;
      if (p.is_smooth()) {
        const Vector3 b = rotation(p.orientation).to_body(r - p.centre);
        is_in = b.x * b.x / 0.25 + b.y * b.y / 0.04 + b.z * b.z / 0.09 < 1.0;
      }
      for (std::size_t k = 0; k < p.sphere_count; ++k)
        is_in = is_in || norm(r - set.spheres[k].centre) < set.spheres[k].radius;
      inside += is_in ? 1 : 0;
      beyond += is_in && dot(r - point, normal) > 0.0 ? 1 : 0;
    }
    const double share = double(beyond) / inside;
    EXPECT_NEAR(share_beyond(set, p, point, normal), share,
                4.0 * std::sqrt(share * (1.0 - share) / inside));
    EXPECT_EQ(share_beyond(set, p, {9.0, 9.0, 9.0}, normal), 0.0);
    EXPECT_EQ(share_beyond(set, p, {-9.0, -9.0, -9.0}, normal), 1.0);
  }
}

TEST(Flow, made_crossings_are_counted) {
  const PeriodicCell open;
  FlowGate plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {}, {}};
  FlowGate disc = plane;
  disc.radius = 0.5;
  FlowGate face;
  face.triangles = {{Vector3{-1.0, -1.0, 0.0}, Vector3{1.0, -1.0, 0.0}, Vector3{0.0, 1.0, 0.0}}};
  const auto frame = [](double z0, double z1, double z2) { // at the axis, beside it, far beside it
    ParticleSet set;
    const Vector3 centres[] = {{0.0, 0.0, z0}, {0.0, -0.8, z1}, {5.0, 0.0, z2}};
    for (int k = 0; k < 3; ++k) {
      Particle p;
      p.id = k;
      p.mass = k + 1.0;
      p.semiaxes = {0.1, 0.1, 0.1};
      p.centre = centres[k];
      set.particles.push_back(p);
    }
    return set;
  };
  struct Expected {
    FlowGate gate;
    double forward, backward;
  };
  for (const Expected& e : {Expected{plane, 1.0 + 2.0, 3.0}, Expected{disc, 1.0, 0.0},
                            Expected{face, 1.0 + 2.0, 0.0}}) {
    FlowThrough flow(e.gate);
    EXPECT_FALSE(flow.advance(frame(-0.2, -0.3, 0.4), open, {}));
    EXPECT_EQ(flow.advance(frame(-0.15, -0.2, 0.3), open, {})->mass_forward, 0.0);
    const FlowStep step = *flow.advance(frame(0.3, 0.4, -0.5), open, {});
    EXPECT_EQ(step.mass_forward, e.forward);
    EXPECT_EQ(step.mass_backward, e.backward);
    const FlowStep gone = *flow.advance(ParticleSet{}, open, {});
    EXPECT_EQ(gone.vanished, 3u);
  }
  // half of a body has passed when its centre reaches the plane
  FlowThrough flow(plane);
  flow.advance(frame(-0.2, -0.3, 0.4), open, {});
  const FlowStep half = *flow.advance(frame(0.0, -0.3, 0.4), open, {});
  EXPECT_NEAR(*half.volume_share_mass, 0.5, 1e-12);
  // around a periodic box: the plane is passed by the way of the nearest image
  const PeriodicCell cell({0.0, 0.0, -0.5},
                          {Vector3{9.0, 0.0, 0.0}, Vector3{0.0, 9.0, 0.0}, Vector3{0.0, 0.0, 1.0}},
                          {false, false, true});
  FlowThrough around({{0.0, 0.0, 0.49}, {0.0, 0.0, 1.0}, {}, {}});
  around.advance(frame(0.48, 0.0, 0.0), cell, {});
  const FlowStep passed = *around.advance(frame(-0.45, 0.0, 0.0), cell, {});
  EXPECT_EQ(passed.forward, 1u);
  EXPECT_EQ(passed.mass_forward, 1.0);
  EXPECT_FALSE(passed.volume_share_mass);
  // around the box beside the plane: counted once, and the volume's share is known
  const PeriodicCell wide({-5.1, -5.0, -5.0},
                          {Vector3{10.2, 0.0, 0.0}, Vector3{0.0, 9.0, 0.0}, Vector3{0.0, 0.0, 9.0}},
                          {true, false, false});
  for (const FlowGate& gate : {plane, FlowGate{{5.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 0.5, {}}}) {
    FlowThrough beside(gate);
    beside.advance(frame(-1.0, -1.0, -0.2), wide, {});
    ParticleSet moved = frame(-1.0, -1.0, 0.3);
    moved.particles[2].centre.x = -5.0; // from 5.0, through the end of the box at 5.1
    const FlowStep once = *beside.advance(moved, wide, {});
    EXPECT_EQ(once.forward, 1u);
    EXPECT_NEAR(*once.volume_share_mass, 3.0, 1e-12);
  }
}

} // namespace
} // namespace ellipsoid::post
