// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Planes between sub-domains against all planes there are.
#include "balance/plane_planning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ellipsoid {
namespace {

/// Heaviest part of any column, from the weights themselves.
double heaviest(const std::vector<std::vector<double>>& columns, const std::vector<int>& planes) {
  double result = 0.0;
  for (const auto& column : columns)
    for (std::size_t part = 1; part < planes.size(); ++part) {
      double sum = 0.0;
      for (int slab = planes[part - 1]; slab < planes[part]; ++slab)
        sum += column[static_cast<std::size_t>(slab)];
      result = std::max(result, sum);
    }
  return result;
}

/// The least that any planes make of it: all of them are tried.
double least_of_all(const std::vector<std::vector<double>>& columns, int parts, int least_slabs,
                    std::vector<int> planes = {0}) {
  const int slabs = static_cast<int>(columns[0].size());
  if (static_cast<int>(planes.size()) == parts) {
    if (slabs - planes.back() < least_slabs)
      return HUGE_VAL;
    planes.push_back(slabs);
    return heaviest(columns, planes);
  }
  double best = HUGE_VAL;
  for (int plane = planes.back() + least_slabs; plane <= slabs; ++plane) {
    planes.push_back(plane);
    best = std::min(best, least_of_all(columns, parts, least_slabs, planes));
    planes.pop_back();
  }
  return best;
}

SlabWeights of_columns(const std::vector<std::vector<double>>& columns) {
  SlabWeights weights(static_cast<int>(columns.size()), static_cast<int>(columns[0].size()));
  std::vector<double>& values = weights.values();
  auto to = values.begin();
  for (const auto& column : columns)
    to = std::copy(column.begin(), column.end(), to);
  return weights;
}

void expect_planes(const std::vector<int>& planes, int slabs, int parts, int least_slabs) {
  ASSERT_EQ(planes.size(), static_cast<std::size_t>(parts) + 1);
  EXPECT_EQ(planes.front(), 0);
  EXPECT_EQ(planes.back(), slabs);
  for (std::size_t k = 1; k < planes.size(); ++k)
    EXPECT_GE(planes[k] - planes[k - 1], least_slabs);
}

TEST(PlanePlanning, no_other_planes_are_better) {
  std::mt19937_64 engine{20261127};
  for (int trial = 0; trial < 600; ++trial) {
    const auto draw = [&](int low, int high) {
      return std::uniform_int_distribution<int>(low, high)(engine);
    };
    const int slabs = draw(4, 14), parts = draw(1, 4), count = draw(1, 4);
    const int least_slabs = draw(1, slabs / parts);
    const bool whole = trial % 2 == 0; // counts, or measured times
    std::vector<std::vector<double>> columns(static_cast<std::size_t>(count));
    double sum = 0.0;
    for (auto& column : columns)
      for (int slab = 0; slab < slabs; ++slab) {
        column.push_back(draw(0, 2) == 0 ? 0.0 : whole ? draw(0, 9) : 0.1 * draw(0, 99));
        sum += column.back();
      }
    const std::vector<int> planes = plan_planes(of_columns(columns), parts, least_slabs);
    expect_planes(planes, slabs, parts, least_slabs);
    const double best = least_of_all(columns, parts, least_slabs), mean = sum / parts / count;
    EXPECT_LE(heaviest(columns, planes), best + 1.1e-3 * mean) << "trial " << trial;
    EXPECT_NEAR(heaviest_part(of_columns(columns), planes), heaviest(columns, planes), 1e-12);
  }
}

TEST(PlanePlanning, a_greedy_cut_would_leave_a_thick_part_too_heavy) {
  // 2 2 2 | 4 3 is as far as 6 reaches, but then 4 and 3 have to stay together
  const std::vector<std::vector<double>> columns{{2, 2, 2, 4, 3, 0, 0}};
  const std::vector<int> planes = plan_planes(of_columns(columns), 3, 2);
  EXPECT_EQ(heaviest(columns, planes), 6.0);
}

TEST(PlanePlanning, an_even_bed_is_cut_evenly) {
  SlabWeights weights(3, 1000);
  for (int column = 0; column < 3; ++column)
    for (int slab = 0; slab < 1000; ++slab)
      weights.add(column, (slab + 0.5) / 1000.0, 2.0);
  EXPECT_EQ(plan_planes(weights, 4, 10), (std::vector<int>{0, 250, 500, 750, 1000}));
}

TEST(PlanePlanning, nothing_to_share_leaves_planes_that_are_allowed) {
  expect_planes(plan_planes(SlabWeights(2, 100), 5, 20), 100, 5, 20);
}

TEST(PlanePlanning, what_lies_outside_counts_at_the_end) {
  SlabWeights weights(1, 10);
  weights.add(0, -0.5, 1.0);
  weights.add(0, 1.5, 2.0);
  weights.add(0, 0.999, 4.0);
  EXPECT_EQ(weights.of(0, 0), 1.0);
  EXPECT_EQ(weights.of(0, 9), 6.0);
}

TEST(PlanePlanning, stages_go_to_neighbouring_parts_only_and_arrive) {
  std::mt19937_64 engine{7};
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t parts = 2 + static_cast<std::size_t>(trial % 9);
    const auto draw = [&] {
      std::vector<double> planes(parts + 1);
      for (double& plane : planes)
        plane = uniform(engine);
      std::sort(planes.begin(), planes.end());
      planes.front() = 0.0;
      planes.back() = 1.0;
      return planes;
    };
    std::vector<double> present = draw();
    const std::vector<double> wanted = draw();
    int stages = 0;
    while (present != wanted && stages < 100) {
      const std::vector<double> next = planes_of_next_stage(present, wanted);
      EXPECT_TRUE(std::is_sorted(next.begin(), next.end()));
      for (std::size_t part = 0; part < parts; ++part) { // overlaps only itself and its neighbours
        EXPECT_GE(next[part + 1], present[part]);
        EXPECT_LE(next[part], present[part + 1]);
      }
      present = next;
      ++stages;
    }
    EXPECT_LE(stages, static_cast<int>(parts));
  }
}

} // namespace
} // namespace ellipsoid
