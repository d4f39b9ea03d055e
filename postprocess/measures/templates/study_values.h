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
    {3, 3, 5, 17.00, 3.57, 32.01},
    {5, 3, 5, 8.65, -4.43, 23.07},
    {7, 2, 5, 4.32, -10.41, 20.30},
    {9, 2, 5, -1.03, -15.61, 14.79},
    {13, 2, 5, 2.87, -11.83, 19.06},
    {17, 2, 5, 1.65, -12.99, 17.53},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {3, 3, 5, 64.70, 58.13, 71.57},
    {5, 3, 5, 27.48, 21.77, 33.40},
    {7, 2, 5, 15.07, 8.94, 21.39},
    {9, 2, 5, 7.96, 1.92, 14.19},
    {13, 2, 5, 3.33, -2.61, 9.52},
    {17, 2, 5, 3.92, -2.03, 10.03},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {3, 3, 5, -14.51, -17.18, -11.79},
    {5, 3, 5, -10.27, -12.99, -7.51},
    {7, 2, 5, -6.81, -9.97, -3.61},
    {9, 2, 5, -3.19, -6.40, 0.05},
    {13, 2, 5, -1.84, -5.04, 1.45},
    {17, 2, 5, -2.60, -5.80, 0.64},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
