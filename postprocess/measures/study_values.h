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
    {3, 2, 3, 17.85, -10.65, 54.24},
    {5, 1, 3, 3.71, -31.50, 46.12},
    {9, 1, 3, 2.61, -32.07, 44.69},
    {13, 1, 3, 4.30, -31.31, 46.85},
    {17, 1, 3, -2.84, -37.22, 38.74},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {3, 2, 3, 63.24, 51.45, 76.10},
    {5, 1, 3, 31.87, 19.03, 45.63},
    {9, 1, 3, 4.22, -7.60, 16.90},
    {13, 1, 3, 0.65, -11.32, 13.19},
    {17, 1, 3, 4.11, -7.76, 16.86},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {3, 2, 3, -15.22, -20.43, -9.81},
    {5, 1, 3, -10.82, -17.70, -3.77},
    {9, 1, 3, -2.14, -9.06, 5.09},
    {13, 1, 3, -1.25, -8.33, 6.01},
    {17, 1, 3, -3.17, -10.10, 4.09},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
