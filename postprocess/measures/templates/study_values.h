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
    {3, 2, 4, 15.86, -5.05, 40.20},
    {5, 2, 4, 9.99, -10.34, 33.63},
    {7, 1, 4, 13.97, -12.68, 43.83},
    {9, 1, 4, 0.87, -25.27, 29.86},
    {13, 1, 4, 2.53, -23.50, 32.01},
    {17, 2, 4, 3.54, -16.53, 26.66},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {3, 2, 4, 63.62, 53.34, 74.70},
    {5, 2, 4, 26.71, 17.69, 36.30},
    {7, 1, 4, 14.67, 3.63, 26.19},
    {9, 1, 4, 4.46, -6.40, 15.73},
    {13, 1, 4, 0.88, -9.83, 12.20},
    {17, 2, 4, 3.20, -5.16, 12.03},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {3, 2, 4, -15.19, -18.91, -11.40},
    {5, 2, 4, -8.92, -12.67, -5.07},
    {7, 1, 4, -6.61, -11.56, -1.59},
    {9, 1, 4, -2.12, -7.12, 2.95},
    {13, 1, 4, -1.22, -6.19, 3.90},
    {17, 2, 4, -2.11, -5.96, 1.82},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
