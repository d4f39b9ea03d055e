// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "recommendation.h"

#include "multisphere/multisphere_template.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

constexpr double same_aspect =
    0.02; ///< relative difference up to which an aspect ratio counts as the one that was run

struct Piled {
  std::string name;
  const std::vector<study::Difference>& differences;
};

std::vector<Piled> piled_quantities() {
  return {{"angle of repose", study::repose_angle},
          {"porosity of piles", study::porosity},
          {"contacts per particle", study::coordination}};
}

bool is_within(const study::Difference& d, double percent) {
  return -percent <= d.low && d.high <= percent;
}

std::string spread_of(const study::Difference& d) {
  return fmt::format("N = {}: {:+.1f} % ({:+.1f} to {:+.1f}; {} and {} smooth runs)", d.subspheres,
                     d.mean, d.low, d.high, d.runs, d.smooth_runs);
}

Advice advice_of_geometry(double aspect, ShapeMeasure measure, double tolerance) {
  const std::string name = word_of(measure);
  try {
    return {name, tolerance, sphere_count_for(aspect, measure, tolerance, SphereSpacing::paper),
            "geometry of the paper's spacing"};
  } catch (const std::invalid_argument& error) {
    return {name, tolerance, 0, error.what()};
  }
}

} // namespace

Advice advice_of_runs(const std::string& quantity,
                      const std::vector<study::Difference>& differences, double tolerance) {
  const double percent = 100.0 * tolerance;
  // from the finest chain downwards, as long as all are within
  auto coarsest = differences.rbegin();
  while (coarsest != differences.rend() && is_within(*coarsest, percent))
    ++coarsest;
  if (coarsest != differences.rbegin()) {
    const study::Difference& d = *std::prev(coarsest);
    return {quantity, tolerance, d.subspheres, "piles, " + spread_of(d)};
  }
  if (differences.empty())
    return {quantity, tolerance, 0, "no piles are kept"};
  const bool is_outside = differences.back().low > percent || differences.back().high < -percent;
  return {quantity, tolerance, 0,
          fmt::format("piles, {}: {}", is_outside ? "not reached" : "undecided",
                      spread_of(differences.back()))};
}

std::vector<Advice> recommend(double aspect, const std::vector<double>& tolerances) {
  std::vector<Advice> advice;
  for (const ShapeMeasure measure :
       {ShapeMeasure::area, ShapeMeasure::volume, ShapeMeasure::outline})
    for (const double tolerance : tolerances)
      advice.push_back(advice_of_geometry(aspect, measure, tolerance));
  const bool was_run = std::abs(aspect / study::aspect_ratio - 1.0) <= same_aspect;
  for (const Piled& piled : piled_quantities())
    for (const double tolerance : tolerances) {
      if (was_run)
        advice.push_back(advice_of_runs(piled.name, piled.differences, tolerance));
      else
        advice.push_back({piled.name, tolerance, 0,
                          fmt::format("no piles were run at this aspect ratio (only {:.3g})",
                                      study::aspect_ratio)});
    }
  return advice;
}

} // namespace ellipsoid::post
