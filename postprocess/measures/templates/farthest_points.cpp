// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "farthest_points.h"

#include "union_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ellipsoid::post {
namespace {

constexpr int looks = 90;          ///< points about the best one
constexpr double shrinking = 0.7;  ///< of the step; steps add up to less than reach_of_climb / 2
constexpr double last_step = 1e-6; ///< of the first one
constexpr std::size_t starts = 60; ///< at most

/// In the unit ball, all directions and distances from its centre.
std::vector<Vector3> looks_in_ball() {
  std::vector<Vector3> points = unit_sphere_points(looks);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] *= std::cbrt((static_cast<double>(k * 37 % looks) + 0.5) / looks);
  return points;
}

void take_step(Climb& climb, const std::vector<Vector3>& ball, double step) {
  const Vector3 from = climb.point;
  for (const Vector3& look : ball) {
    const Vector3 point = climb.onto(from + step * look);
    const double value = climb.value_at(point);
    if (value > climb.value) {
      climb.value = value;
      climb.point = point;
    }
  }
}

} // namespace

double highest(std::vector<Climb> climbs, double first_step) {
  const std::vector<Vector3> ball = looks_in_ball();
  double best = 0.0;
  for (double step = first_step; step > last_step * first_step; step *= shrinking) {
    for (Climb& climb : climbs) {
      take_step(climb, ball, step);
      best = std::max(best, climb.value);
    }
    climbs.erase(std::remove_if(climbs.begin(), climbs.end(),
                                [&](const Climb& climb) {
                                  return climb.value + reach_of_climb * step < best;
                                }),
                 climbs.end());
  }
  return best;
}

std::vector<std::size_t> largest_samples(const std::vector<Vector3>& points,
                                         const std::vector<double>& values, double apart) {
  std::vector<std::size_t> order(points.size()), chosen;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t k, std::size_t l) { return values[k] > values[l]; });
  for (const std::size_t k : order) {
    if (chosen.size() == starts)
      break;
    if (std::none_of(chosen.begin(), chosen.end(),
                     [&](std::size_t l) { return norm(points[k] - points[l]) < apart; }))
      chosen.push_back(k);
  }
  return chosen;
}

} // namespace ellipsoid::post
