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
    {3, 3, 5, 17.00, 4.61, 30.70},
    {5, 3, 5, 8.65, -3.35, 21.75},
    {7, 3, 5, 2.89, -8.82, 15.71},
    {9, 2, 5, -1.03, -14.46, 13.42},
    {13, 2, 5, 2.87, -10.59, 17.54},
    {17, 3, 5, 1.53, -10.28, 14.25},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {3, 3, 5, 64.70, 58.50, 71.20},
    {5, 3, 5, 27.48, 22.10, 33.06},
    {7, 3, 5, 13.83, 8.74, 19.11},
    {9, 2, 5, 7.96, 2.23, 13.84},
    {13, 2, 5, 3.33, -2.27, 9.14},
    {17, 3, 5, 4.27, -0.70, 9.34},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {3, 3, 5, -14.51, -17.09, -11.87},
    {5, 3, 5, -10.27, -12.89, -7.62},
    {7, 3, 5, -5.97, -8.62, -3.27},
    {9, 2, 5, -3.19, -6.30, -0.06},
    {13, 2, 5, -1.84, -4.93, 1.32},
    {17, 3, 5, -2.27, -4.99, 0.46},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
