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
    {3, 3, 5, 17.00, 4.23, 31.24},
    {5, 3, 5, 8.65, -3.80, 22.39},
    {7, 2, 5, 4.32, -9.78, 19.61},
    {9, 2, 5, -1.03, -14.92, 13.94},
    {13, 2, 5, 2.87, -11.15, 18.13},
    {17, 3, 5, 1.53, -10.58, 14.85},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {3, 3, 5, 64.70, 58.45, 71.25},
    {5, 3, 5, 27.48, 22.05, 33.15},
    {7, 2, 5, 15.07, 9.19, 21.15},
    {9, 2, 5, 7.96, 2.20, 13.88},
    {13, 2, 5, 3.33, -2.36, 9.21},
    {17, 3, 5, 4.27, -0.70, 9.43},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {3, 3, 5, -14.51, -17.06, -11.89},
    {5, 3, 5, -10.27, -12.87, -7.63},
    {7, 2, 5, -6.81, -9.86, -3.73},
    {9, 2, 5, -3.19, -6.27, -0.10},
    {13, 2, 5, -1.84, -4.92, 1.30},
    {17, 3, 5, -2.27, -4.94, 0.46},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
