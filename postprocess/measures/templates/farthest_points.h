// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The largest distance of a surface's points from something, refined from samples of it.
#pragma once

#include "math/vector3.h"

#include <functional>
#include <vector>

namespace ellipsoid::post {

/// A search that starts at a point of a surface and goes where the value is larger.
struct Climb {
  Vector3 point;                                  ///< (length)
  double value = 0.0;                             ///< there (length)
  std::function<Vector3(const Vector3&)> onto;    ///< a point of the surface near the one given
  std::function<double(const Vector3&)> value_at; ///< negative where the surface has no such point
};

/// How far a climb may go from its start in units of the first step.
constexpr double reach_of_climb = 7.0;

/// The largest value that the climbs find. Each looks at points about its best one, at all
/// distances up to the step, then makes the step smaller, down to 1e-6 of the first one. Climbs
/// that cannot overtake the best one are given up: no value changes by more than the way.
/// @param[in] first_step (length), the distance of neighbouring samples
double highest(std::vector<Climb> climbs, double first_step);

/// Indices of the samples with the largest values, apart from each other by the distance at least,
/// the largest first.
std::vector<std::size_t> largest_samples(const std::vector<Vector3>& points,
                                         const std::vector<double>& values, double apart);

} // namespace ellipsoid::post
