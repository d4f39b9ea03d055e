// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How many sub-spheres an aspect ratio needs: by geometry, and by the piles that were run.
#pragma once

#include "study_values.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// One line of advice.
struct Advice {
  std::string quantity; ///< area, volume, outline, angle of repose, porosity, coordination number
  double tolerance;     ///< share of the smooth ellipsoid's value
  int subspheres;       ///< smallest N; 0: none is known
  std::string source;   ///< what it rests on, or why none is known
};

/// Smallest N whose difference, and that of every larger N that was run, lies within the tolerance
/// with 95 %.
/// @param differences by N, ascending
/// @param tolerance share, for example 0.05
Advice advice_of_runs(const std::string& quantity,
                      const std::vector<study::Difference>& differences, double tolerance);

/// Advice for each quantity and tolerance. Piles count only for the aspect ratio that was run (to 2
/// %); for others it is said that they were not.
/// @param aspect a / b > 1
std::vector<Advice> recommend(double aspect, const std::vector<double>& tolerances);

} // namespace ellipsoid::post
