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
    {3, 2, 3, 17.85, -10.91, 54.39},
    {5, 1, 3, 3.71, -31.66, 45.87},
    {7, 1, 3, 15.93, -19.93, 60.11},
    {9, 1, 3, 2.61, -32.65, 44.63},
    {13, 1, 3, 4.30, -30.70, 46.59},
    {17, 1, 3, -2.84, -37.26, 38.53},
// study: end
};

/// Porosity.
inline const std::vector<Difference> porosity = {
// study: porosity
    {3, 2, 3, 63.24, 51.30, 76.22},
    {5, 1, 3, 31.87, 18.97, 45.55},
    {7, 1, 3, 14.41, 2.12, 27.50},
    {9, 1, 3, 4.22, -7.74, 16.85},
    {13, 1, 3, 0.65, -11.24, 13.17},
    {17, 1, 3, 4.11, -7.76, 16.74},
// study: end
};

/// Contacts per particle.
inline const std::vector<Difference> coordination = {
// study: zpp
    {3, 2, 3, -15.22, -20.48, -9.79},
    {5, 1, 3, -10.82, -17.75, -3.81},
    {7, 1, 3, -6.64, -13.56, 0.52},
    {9, 1, 3, -2.14, -9.14, 5.07},
    {13, 1, 3, -1.25, -8.29, 5.99},
    {17, 1, 3, -3.17, -10.10, 4.01},
// study: end
};
// clang-format on

} // namespace ellipsoid::post::study
