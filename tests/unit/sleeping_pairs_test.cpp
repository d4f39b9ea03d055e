// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Sleeping pairs against a list of all pairs that is asked in every step.
#include "sleeping_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace ellipsoid {
namespace {

using IndexPair = std::pair<int, int>;

/// Bodies with ways of very different lengths, and what a pair has to travel from when.
struct Crowd {
  static constexpr int bodies = 60, steps = 4000;
  std::mt19937_64 engine{20100603};
  std::vector<IndexPair> pairs;
  std::vector<double> gap, start; ///< by place; gap 0: the pair is awake
  SleepingPairs sleeping;
  Travels travels;

  Crowd() {
    for (int i = 0; i < bodies; ++i)
      for (int k = 0; k < i % 7; ++k)
        pairs.emplace_back(i, (i + 1 + 5 * k) % bodies);
    gap.assign(pairs.size(), 0.0);
    start.assign(pairs.size(), 0.0);
    sleeping.restart(bodies, [this](const auto& visit) {
      for (const IndexPair& pair : pairs)
        visit(pair.first, pair.second);
    });
    travels.restart(bodies);
  }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  double travelled(std::size_t place) const {
    return travels.path(pairs[place].first) + travels.path(pairs[place].second);
  }
  void sleep(std::size_t place) {
    gap[place] = std::pow(10.0, uniform(-3.0, 2.0));
    start[place] = travelled(place);
    sleeping.sleep(place, pairs[place].first, gap[place], travels);
  }
  /// Some bodies rest most of the time, one is fast.
  void move() {
    for (int body = 0; body < bodies; ++body) {
      const bool rests = body % 3 == 0 && uniform(0.0, 1.0) < 0.9;
      travels.add(static_cast<std::size_t>(body),
                  rests ? 0.0 : uniform(0.0, body == 7 ? 3.0 : 0.01));
    }
  }
};

} // namespace

TEST(SleepingPairs, wake_when_their_gap_is_travelled_and_not_before) {
  Crowd crowd;
  for (std::size_t place = 0; place < crowd.pairs.size(); ++place)
    crowd.sleep(place);
  int woken = 0;
  for (int step = 0; step < Crowd::steps; ++step) {
    crowd.move();
    std::set<std::size_t> due;
    crowd.sleeping.wake(crowd.travels, [&](std::size_t place, int i, int j) {
      EXPECT_EQ(crowd.pairs[place], IndexPair(i, j));
      EXPECT_TRUE(due.insert(place).second) << "woken twice";
    });
    for (std::size_t place = 0; place < crowd.pairs.size(); ++place) {
      const double travelled = crowd.travelled(place) - crowd.start[place];
      if (travelled >= crowd.gap[place]) {
        EXPECT_TRUE(due.count(place)) << "step " << step << ", pair " << place;
      }
      if (due.count(place)) { // deadlines are rounded down to single precision
        EXPECT_GE(travelled, crowd.gap[place] - 1e-6 * crowd.travelled(place));
      }
    }
    woken += static_cast<int>(due.size());
    for (const std::size_t place : due)
      crowd.sleep(place);
  }
  EXPECT_GT(woken, 1000);
}

TEST(SleepingPairs, pairs_that_are_awake_are_left_alone) {
  Crowd crowd;
  crowd.sleep(3);
  for (int step = 0; step < Crowd::steps; ++step) {
    crowd.move();
    crowd.sleeping.wake(crowd.travels, [&](std::size_t place, int, int) {
      EXPECT_EQ(place, 3u);
      EXPECT_GE(crowd.travelled(place), crowd.gap[place] * (1.0 - 1e-6));
    });
  }
  EXPECT_EQ(crowd.sleeping.size(), crowd.pairs.size());
}

TEST(SleepingPairs, restart_forgets_all) {
  Crowd crowd;
  for (std::size_t place = 0; place < crowd.pairs.size(); ++place)
    crowd.sleep(place);
  crowd.sleeping.restart(2, [](const auto& visit) { visit(1, 0); });
  crowd.travels.restart(2);
  crowd.travels.add(0, 1e9);
  crowd.sleeping.wake(crowd.travels, [](std::size_t, int, int) { FAIL(); });
  EXPECT_EQ(crowd.sleeping.first_place(1), 0u);
  crowd.sleeping.sleep(0, 1, 2.0, crowd.travels);
  crowd.travels.add(1, 2.5);
  int woken = 0;
  crowd.sleeping.wake(crowd.travels, [&](std::size_t, int, int) { ++woken; });
  EXPECT_EQ(woken, 1);
}

} // namespace ellipsoid
