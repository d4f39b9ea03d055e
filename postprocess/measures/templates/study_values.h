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
    {3, 3, 5, 17.00, 5.34, 29.89},
    {5, 3, 5, 8.65, -2.60, 21.00},
    {7, 3, 5, 2.89, -8.17, 14.90},
    {9, 3, 5, 0.93, -10.15, 12.92},
    {13, 3, 5, 2.09, -8.93, 14.19},
    {17, 3, 5, 1.53, -9.49, 13.50},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {3, 3, 5, 64.70, 58.95, 70.75},
    {5, 3, 5, 27.48, 22.52, 32.66},
    {7, 3, 5, 13.83, 9.11, 18.72},
    {9, 3, 5, 8.12, 3.46, 12.92},
    {13, 3, 5, 3.12, -1.42, 7.86},
    {17, 3, 5, 4.27, -0.30, 8.99},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {3, 3, 5, -14.51, -17.02, -11.95},
    {5, 3, 5, -10.27, -12.82, -7.67},
    {7, 3, 5, -5.97, -8.56, -3.33},
    {9, 3, 5, -4.01, -6.64, -1.34},
    {13, 3, 5, -1.46, -4.09, 1.26},
    {17, 3, 5, -2.27, -4.90, 0.41},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
