// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the study's piles say of multi-sphere particles against smooth ones; `bash inputs/study.sh`
// writes the rows from the runs that are kept in inputs/results (src_liggghts/doc/study.md).
#pragma once

#include <vector>

namespace ellipsoid::post::study {

constexpr double aspect_ratio = 2.7 / 1.15; ///< of the particles that were piled up

/// How far the mean of N sub-spheres lies from that of smooth ellipsoids, in percent of the latter.
struct Difference {
  int subspheres, runs, smooth_runs;
  double mean, low, high; ///< low to high: 95 %
};

// clang-format off
/// Angle of repose.
inline const std::vector<Difference> repose_angle = {
// study: repose_angle_deg
    {5, 1, 2, -1.22, -16.61, 14.48},
    {17, 1, 2, -7.46, -23.01, 7.66},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {5, 1, 2, 31.34, -2.37, 65.77},
    {17, 1, 2, 3.70, -27.45, 34.07},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {5, 1, 2, -10.53, -35.80, 14.91},
    {17, 1, 2, -2.86, -29.02, 22.81},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
