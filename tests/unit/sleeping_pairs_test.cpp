// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Sleeping pairs against a list of all pairs that is asked in every step.
#include "separation/sleeping_pairs.h"

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
  struct Nap {
    double gap = 0.0, left = 0.0; ///< 0: the pair is awake
    Vector3 normal;
  };
  std::vector<Nap> naps; ///< by place
  std::vector<Motion> motions = std::vector<Motion>(bodies);
  SleepingPairs sleeping;
  MotionClocks clocks;

  Crowd() {
    for (int i = 0; i < bodies; ++i)
      for (int k = 0; k < i % 7; ++k)
        pairs.emplace_back(i, (i + 1 + 5 * k) % bodies);
    naps.resize(pairs.size());
    sleeping.restart(bodies, [this](const auto& visit) {
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
  void sleep(std::size_t place) {
    const auto [i, j] = pairs[place];
    Nap& nap = naps[place];
    nap.gap = nap.left = std::pow(10.0, uniform(-3.0, 2.0));
    nap.normal = direction();
    sleeping.sleep(place, i, nap.gap, clocks.approach(i, j, nap.normal), clocks);
  }
  void sleep_all() {
    for (std::size_t place = 0; place < pairs.size(); ++place)
      sleep(place);
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
    for (std::size_t place = 0; place < pairs.size(); ++place) {
      const Motion &i = motions[static_cast<std::size_t>(pairs[place].first)],
                   &j = motions[static_cast<std::size_t>(pairs[place].second)];
      naps[place].left -=
          dot(naps[place].normal, i.displacement - j.displacement) + i.turn + j.turn;
    }
  }
};

} // namespace

TEST(SleepingPairs, wake_before_they_can_touch) {
  Crowd crowd;
  crowd.sleep_all();
  int woken = 0, in_time = 0;
  for (int step = 0; step < Crowd::steps; ++step) {
    crowd.move();
    std::set<std::size_t> due;
    crowd.sleeping.wake(crowd.clocks, [&](std::size_t place, int i, int j) {
      EXPECT_EQ(crowd.pairs[place], IndexPair(i, j));
      EXPECT_TRUE(due.insert(place).second) << "woken twice";
    });
    for (std::size_t place = 0; place < crowd.pairs.size(); ++place) {
      if (crowd.naps[place].left <= 0.0) {
        EXPECT_TRUE(due.count(place)) << "step " << step << ", pair " << place;
        ++in_time;
      }
    }
    woken += static_cast<int>(due.size());
    for (const std::size_t place : due)
      crowd.sleep(place);
  }
  EXPECT_GT(woken, 1000);
  EXPECT_GT(in_time, 100);                                                    // the fast body
  EXPECT_LT(woken, Crowd::steps * static_cast<int>(crowd.pairs.size()) / 20); // they do sleep
}

TEST(SleepingPairs, pairs_that_are_awake_are_left_alone) {
  Crowd crowd;
  crowd.sleep(3);
  int woken = 0;
  for (int step = 0; step < Crowd::steps; ++step) {
    crowd.move();
    crowd.sleeping.wake(crowd.clocks, [&](std::size_t place, int, int) {
      EXPECT_EQ(place, 3U);
      ++woken;
    });
  }
  EXPECT_EQ(woken, 1);
  EXPECT_EQ(crowd.sleeping.size(), crowd.pairs.size());
}

TEST(SleepingPairs, nobody_wakes_where_nothing_moves) {
  Crowd crowd;
  crowd.sleep_all();
  for (int step = 0; step < 1000; ++step) {
    crowd.clocks.begin_step();
    for (std::size_t body = 0; body < Crowd::bodies; ++body)
      crowd.clocks.advance(body, Motion());
    crowd.sleeping.wake(crowd.clocks, [&](std::size_t place, int, int) {
      ADD_FAILURE() << "pair " << place << " in step " << step;
    });
  }
}

TEST(SleepingPairs, restart_forgets_all) {
  Crowd crowd;
  crowd.sleep_all();
  crowd.sleeping.restart(2, [](const auto& visit) { visit(1, 0); });
  crowd.clocks.restart(2);
  const auto advance = [&crowd](double way) {
    crowd.clocks.begin_step();
    crowd.clocks.advance(0, {{way, 0.0, 0.0}, 0.0});
    crowd.clocks.advance(1, {{0.0, 0.0, 0.0}, 0.0});
  };
  advance(1e9);
  crowd.sleeping.wake(crowd.clocks, [](std::size_t, int, int) { FAIL(); });
  EXPECT_EQ(crowd.sleeping.first_place(1), 0U);
  crowd.sleeping.sleep(0, 1, 2.0, crowd.clocks.approach(1, 0, {-1.0, 0.0, 0.0}), crowd.clocks);
  advance(2.5);
  int woken = 0;
  crowd.sleeping.wake(crowd.clocks, [&](std::size_t, int, int) { ++woken; });
  EXPECT_EQ(woken, 1);
}

} // namespace ellipsoid
