// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Deadlines of motion clocks against the motion itself.
#include "separation/motion_clocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ellipsoid {
namespace {

const Vector3 along_x{1.0, 0.0, 0.0};

/// Body 0 to the left of body 1.
struct TwoBodies {
  MotionClocks clocks;
  TwoBodies() { clocks.restart(2); }
  void step(const Motion& left, const Motion& right) {
    clocks.begin_step();
    clocks.advance(0, left);
    clocks.advance(1, right);
  }
  MotionClocks::Deadlines deadlines(double gap) {
    return clocks.deadlines(0, 1, gap, clocks.approach(0, 1, along_x));
  }
  bool due(const MotionClocks::Deadlines& until) const {
    return clocks.time(0) >= until.i || clocks.time(1) >= until.j;
  }
};

} // namespace

TEST(MotionClocks, motion_in_common_costs_nothing) {
  TwoBodies bodies;
  const Motion common{{3.0, -2.0, 1.0}, 0.0};
  bodies.clocks.expect(0, common);
  bodies.clocks.expect(1, common);
  bodies.step(common, common);
  const auto until = bodies.deadlines(1e-6);
  for (int step = 0; step < 100; ++step) {
    bodies.step(common, common);
    ASSERT_FALSE(bodies.due(until)) << "step " << step;
  }
}

TEST(MotionClocks, steady_approach_uses_up_the_gap) {
  TwoBodies bodies;
  const Motion left{{0.03, 0.5, 0.0}, 0.001}, right{{-0.01, 0.5, 0.0}, 0.002};
  for (int step = 0; step < 100000; ++step) // the first change is forgotten
    bodies.step(left, right);
  EXPECT_NEAR(bodies.clocks.approach(0, 1, along_x), 0.043, 1e-15);
  EXPECT_NEAR(bodies.clocks.approach(0, 1), 0.043, 1e-15);
  EXPECT_NEAR(bodies.clocks.approach(0, 1, -1.0 * along_x), -0.037, 1e-15);
  const double gap = 0.1;
  const auto until = bodies.deadlines(gap);
  int steps = 0;
  do {
    bodies.step(left, right);
    ++steps;
  } while (!bodies.due(until));
  EXPECT_LE((steps - 1) * 0.043, gap); // asleep a step before
  EXPECT_GE((steps + 1) * 0.043, gap);
}

TEST(MotionClocks, are_never_late) {
  std::mt19937_64 engine(20100603);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto vector = [&](double deviation) {
    return Vector3{deviation * normal(engine), deviation * normal(engine),
                   deviation * normal(engine)};
  };
  double slept = 0.0;
  int naps = 0, close = 0;
  for (int crowd = 0; crowd < 200; ++crowd) {
    TwoBodies bodies;
    Motion left{vector(1.0), 0.3}, right{left.displacement + vector(0.2), 0.1};
    const double quiet = uniform(engine);
    double gap = 0.0, travelled = 0.0;
    MotionClocks::Deadlines until{0.0, 0.0};
    for (int step = 0; step < 2000; ++step) {
      if (uniform(engine) > quiet)
        left = {left.displacement + vector(0.01), std::fabs(left.turn + 0.001 * normal(engine))};
      if (uniform(engine) > quiet)
        right.displacement += vector(0.05);
      bodies.step(left, right);
      travelled += dot(along_x, left.displacement - right.displacement) + left.turn + right.turn;
      if (!bodies.due(until)) {
        ASSERT_LT(travelled, gap) << "crowd " << crowd << ", step " << step;
        slept += 1.0;
        continue;
      }
      close += travelled > 0.5 * gap;
      ++naps;
      gap = std::exp(3.0 * normal(engine));
      travelled = 0.0;
      until = bodies.deadlines(gap);
    }
  }
  EXPECT_GT(slept / naps, 2.0);
  EXPECT_GT(close, naps / 10); // gaps are really used
}

TEST(MotionClocks, gap_for_is_what_deadlines_need) {
  TwoBodies bodies;
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int step = 0; step < 1000; ++step)
    bodies.step({{uniform(engine), 0.0, 0.0}, 0.0}, {{uniform(engine), 0.0, 0.0}, 0.1});
  const double pace = bodies.deadlines(1.0).i - bodies.clocks.time(0);
  ASSERT_GT(pace, 0.0);
  for (const double steps : {0.5, 3.0, 40.0})
    for (const double approach : {0.0, 0.01, 0.5, 20.0}) {
      const double gap = bodies.clocks.gap_for(steps, 0, 1, approach);
      const auto until = bodies.clocks.deadlines(0, 1, gap, approach);
      const auto twice = bodies.clocks.deadlines(
          0, 1, bodies.clocks.gap_for(2.0 * steps, 0, 1, approach), approach);
      const double span = until.i - bodies.clocks.time(0);
      EXPECT_NEAR(twice.i - bodies.clocks.time(0), 2.0 * span, 1e-6 * span);
      EXPECT_NEAR((until.j - bodies.clocks.time(1)) / span,
                  (twice.j - bodies.clocks.time(1)) / (2.0 * span), 1e-6);
    }
}

TEST(MotionClocks, restart_remembers_only_what_is_usual) {
  TwoBodies bodies;
  for (int step = 0; step < 10; ++step)
    bodies.step({{1.0, 0.0, 0.0}, 0.0}, {{step % 2 * 2.0, 0.0, 0.0}, 0.0});
  TwoBodies others = bodies, fresh;
  others.clocks.forget();
  others.clocks.restart(2);
  EXPECT_EQ(others.deadlines(1.0).i, fresh.deadlines(1.0).i);
  bodies.clocks.restart(2);
  EXPECT_GT(bodies.deadlines(1.0).i, fresh.deadlines(1.0).i);
  bodies.clocks.restart(1);
  EXPECT_EQ(bodies.clocks.size(), 1U);
  EXPECT_EQ(bodies.clocks.time(0), 0.0);
  bodies.clocks.restart(2);
  bodies.clocks.expect(0, {{5.0, 0.0, 0.0}, 0.0});
  EXPECT_EQ(bodies.clocks.approach(0, 1, along_x), 5.0);
  const auto until = bodies.deadlines(100.0);
  for (int step = 1; step < 20; ++step) {
    bodies.step({{5.0, 0.0, 0.0}, 0.0}, {});
    ASSERT_FALSE(bodies.due(until)) << "step " << step;
  }
  bodies.step({{5.0, 0.0, 0.0}, 0.0}, {});
  EXPECT_TRUE(bodies.due(until));
}

TEST(MotionClocks, margins_are_used_up_by_any_motion) {
  std::mt19937_64 engine(20261127);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int body : {0, 1, 70, 199}) { // of several batches
    MotionClocks clocks;
    clocks.restart(200);
    for (std::size_t k = 0; k < clocks.size(); ++k)
      clocks.set_margin(k, static_cast<int>(k) == body ? 1.0 : 2.0);
    double moved = 0.0;
    int steps = 0;
    do {
      ASSERT_LE(moved, 1.0) << "body " << body;
      const double share = 0.01 * uniform(engine), length = 0.01 * uniform(engine);
      const Motion motion{{0.6 * length, 0.0, -0.8 * length}, share};
      clocks.advance_all([&motion](std::size_t, Motions& motions) {
        for (int k = 0; k < motions.count; ++k)
          motions.set(k, motion);
      });
      moved += length + share;
      EXPECT_NEAR(clocks.way(7), length + share, 1e-17);
      EXPECT_NEAR(clocks.margin(body), 1.0 - moved, 1e-8);
      ++steps;
    } while (!clocks.a_margin_is_used_up());
    EXPECT_GT(moved, 1.0 - 1e-8);
    EXPECT_GT(steps, 50);
    clocks.set_margin(static_cast<std::size_t>(body), 1.0);
    clocks.advance_all([](std::size_t, Motions& motions) {
      for (int k = 0; k < motions.count; ++k)
        motions.set(k, {});
    });
    EXPECT_FALSE(clocks.a_margin_is_used_up());
  }
}

} // namespace ellipsoid
