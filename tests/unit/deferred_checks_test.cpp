// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Deferred checks against a list of all pairs that is asked in every step.
#include "separation/deferred_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace ellipsoid {
namespace {

using IndexPair = std::pair<int, int>;

/// Bodies that move in very different ways, and how near those of a pair may have come.
struct Crowd {
  static constexpr int bodies = 60, steps = 4000;
  std::mt19937_64 engine{20100603};
  std::vector<IndexPair> pairs;
  struct Deferral {
    double gap = 0.0, left = 0.0; ///< 0: not deferred
    Vector3 normal;
  };
  std::vector<Deferral> deferrals; ///< by index
  std::vector<Motion> motions = std::vector<Motion>(bodies);
  DeferredChecks checks;
  MotionClocks clocks;

  Crowd() {
    for (int i = 0; i < bodies; ++i)
      for (int k = 0; k < i % 7; ++k)
        pairs.emplace_back(i, (i + 1 + 5 * k) % bodies);
    deferrals.resize(pairs.size());
    checks.restart(bodies, [this](const auto& visit) {
      for (const IndexPair& pair : pairs)
        visit(pair.first, pair.second);
    });
    clocks.restart(bodies);
  }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Vector3 direction() {
    std::normal_distribution<double> normal;
    return normalized(Vector3{normal(engine), normal(engine), normal(engine)});
  }
  void defer(std::size_t index) {
    const auto [i, j] = pairs[index];
    Deferral& deferral = deferrals[index];
    deferral.gap = deferral.left = std::pow(10.0, uniform(-3.0, 2.0));
    deferral.normal = direction();
    checks.defer(index, i, deferral.gap, clocks.approach(i, j, deferral.normal), clocks);
  }
  void defer_all() {
    for (std::size_t index = 0; index < pairs.size(); ++index)
      defer(index);
  }
  /// Some bodies rest most of the time, one is fast, all others are carried along and pushed about.
  void move() {
    clocks.begin_step();
    for (int body = 0; body < bodies; ++body) {
      Motion& motion = motions[static_cast<std::size_t>(body)];
      if (body % 3 == 0)
        motion = uniform(0.0, 1.0) < 0.9 ? Motion() : Motion{0.01 * direction(), 0.001};
      else if (uniform(0.0, 1.0) < 0.05)
        motion = {(body == 7 ? 3.0 : 0.005) * direction() + Vector3{0.02, 0.0, 0.0},
                  uniform(0.0, 0.005)};
      clocks.advance(static_cast<std::size_t>(body), motion);
    }
    for (std::size_t index = 0; index < pairs.size(); ++index) {
      const Motion &i = motions[static_cast<std::size_t>(pairs[index].first)],
                   &j = motions[static_cast<std::size_t>(pairs[index].second)];
      deferrals[index].left -=
          dot(deferrals[index].normal, i.displacement - j.displacement) + i.turn + j.turn;
    }
  }
};

} // namespace

TEST(DeferredChecks, are_due_before_they_can_touch) {
  Crowd crowd;
  crowd.defer_all();
  int found = 0, in_time = 0;
  for (int step = 0; step < Crowd::steps; ++step) {
    crowd.move();
    std::set<std::size_t> due;
    crowd.checks.end_due(crowd.clocks, [&](std::size_t index, int i, int j) {
      EXPECT_EQ(crowd.pairs[index], IndexPair(i, j));
      EXPECT_TRUE(due.insert(index).second) << "due twice";
    });
    for (std::size_t index = 0; index < crowd.pairs.size(); ++index) {
      if (crowd.deferrals[index].left <= 0.0) {
        EXPECT_TRUE(due.count(index)) << "step " << step << ", pair " << index;
        ++in_time;
      }
    }
    found += static_cast<int>(due.size());
    for (const std::size_t index : due)
      crowd.defer(index);
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(in_time, 100);                                                    // the fast body
  EXPECT_LT(found, Crowd::steps * static_cast<int>(crowd.pairs.size()) / 20); // they are deferred
}

TEST(DeferredChecks, pairs_that_are_not_deferred_are_left_alone) {
  Crowd crowd;
  crowd.defer(3);
  int found = 0;
  for (int step = 0; step < Crowd::steps; ++step) {
    crowd.move();
    crowd.checks.end_due(crowd.clocks, [&](std::size_t index, int, int) {
      EXPECT_EQ(index, 3U);
      ++found;
    });
  }
  EXPECT_EQ(found, 1);
  EXPECT_EQ(crowd.checks.size(), crowd.pairs.size());
}

TEST(DeferredChecks, nothing_is_due_where_nothing_moves) {
  Crowd crowd;
  crowd.defer_all();
  for (int step = 0; step < 1000; ++step) {
    crowd.clocks.begin_step();
    for (std::size_t body = 0; body < Crowd::bodies; ++body)
      crowd.clocks.advance(body, Motion());
    crowd.checks.end_due(crowd.clocks, [&](std::size_t index, int, int) {
      ADD_FAILURE() << "pair " << index << " in step " << step;
    });
  }
}

TEST(DeferredChecks, restart_forgets_all) {
  Crowd crowd;
  crowd.defer_all();
  crowd.checks.restart(2, [](const auto& visit) { visit(1, 0); });
  crowd.clocks.restart(2);
  const auto advance = [&crowd](double way) {
    crowd.clocks.begin_step();
    crowd.clocks.advance(0, {{way, 0.0, 0.0}, 0.0});
    crowd.clocks.advance(1, {{0.0, 0.0, 0.0}, 0.0});
  };
  advance(1e9);
  crowd.checks.end_due(crowd.clocks, [](std::size_t, int, int) { FAIL(); });
  EXPECT_EQ(crowd.checks.first_index(1), 0U);
  crowd.checks.defer(0, 1, 2.0, crowd.clocks.approach(1, 0, {-1.0, 0.0, 0.0}), crowd.clocks);
  advance(2.5);
  int found = 0;
  crowd.checks.end_due(crowd.clocks, [&](std::size_t, int, int) { ++found; });
  EXPECT_EQ(found, 1);
}

} // namespace ellipsoid
