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
    {3, 1, 2, 20.79, 4.36, 37.35},
    {5, 1, 2, -1.22, -16.44, 14.19},
    {17, 1, 2, -7.46, -22.83, 7.44},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {3, 1, 2, 66.32, 28.67, 104.10},
    {5, 1, 2, 31.34, -1.38, 65.18},
    {17, 1, 2, 3.70, -27.28, 34.00},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {3, 1, 2, -16.94, -41.53, 7.57},
    {5, 1, 2, -10.53, -34.96, 14.69},
    {17, 1, 2, -2.86, -28.91, 22.58},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
