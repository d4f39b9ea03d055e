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
    {3, 2, 4, 15.86, -4.52, 39.52},
    {5, 2, 4, 9.99, -10.01, 33.06},
    {7, 2, 4, 6.25, -13.57, 29.08},
    {9, 1, 4, 0.87, -24.98, 29.28},
    {13, 1, 4, 2.53, -23.15, 31.19},
    {17, 2, 4, 3.54, -16.19, 25.82},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {3, 2, 4, 63.62, 54.44, 73.45},
    {5, 2, 4, 26.71, 18.61, 35.25},
    {7, 2, 4, 14.28, 6.50, 22.47},
    {9, 1, 4, 4.46, -5.36, 14.54},
    {13, 1, 4, 0.88, -8.80, 10.92},
    {17, 2, 4, 3.20, -4.33, 10.98},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {3, 2, 4, -15.19, -18.51, -11.82},
    {5, 2, 4, -8.92, -12.30, -5.51},
    {7, 2, 4, -6.35, -9.76, -2.86},
    {9, 1, 4, -2.12, -6.64, 2.43},
    {13, 1, 4, -1.22, -5.72, 3.35},
    {17, 2, 4, -2.11, -5.58, 1.36},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
