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
    {3, 3, 5, 17.00, 2.86, 32.87},
    {5, 2, 5, 7.99, -7.69, 25.07},
    {7, 2, 5, 4.32, -11.21, 21.38},
    {9, 2, 5, -1.03, -16.32, 15.63},
    {13, 2, 5, 2.87, -12.57, 19.89},
    {17, 2, 5, 1.65, -13.63, 18.33},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {3, 3, 5, 64.70, 57.78, 71.97},
    {5, 2, 5, 27.59, 20.86, 34.53},
    {7, 2, 5, 15.07, 8.59, 21.82},
    {9, 2, 5, 7.96, 1.62, 14.52},
    {13, 2, 5, 3.33, -2.94, 9.84},
    {17, 2, 5, 3.92, -2.32, 10.34},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {3, 3, 5, -14.51, -17.14, -11.82},
    {5, 2, 5, -9.37, -12.48, -6.25},
    {7, 2, 5, -6.81, -9.94, -3.62},
    {9, 2, 5, -3.19, -6.35, -0.00},
    {13, 2, 5, -1.84, -5.01, 1.39},
    {17, 2, 5, -2.60, -5.73, 0.59},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
