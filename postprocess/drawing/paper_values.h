// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What Markauskas et al. 2010 report of their piles and runs; margins are half ranges.
#pragma once

#include <vector>

namespace ellipsoid::post::paper {

/// A reported value for N sub-spheres; N = 0 is the smooth ellipse.
struct Reported {
  int subspheres = 0;
  double value = 0.0, margin = 0.0;
};

/// Angle of repose (deg), section 4.2.1; the smooth range is 20.8 to 24.4. 13 sub-spheres: 3.7 %
/// above the ellipse. 5 sub-spheres: one pictured run (figure 11).
inline const std::vector<Reported> repose_angle = {
    {0, 22.7, 1.8}, {3, 29.1, 0.0}, {5, 26.6, 0.0}, {13, 22.7 * 1.037, 0.0}, {17, 23.3, 0.0}};

/// Porosity, section 4.2.2; the smooth margin is 4.0 %.
inline const std::vector<Reported> porosity = {
    {0, 0.13, 0.04 * 0.13}, {3, 0.25, 0.0}, {17, 0.14, 0.0}};

/// Coordination number particle-particle, section 4.2.3; the smooth margin is 2.5 %.
inline const std::vector<Reported> coordination = {{0, 3.90, 0.025 * 3.90}, {17, 3.90, 0.0}};

/// CPU time relative to plain spheres, section 5.
inline const std::vector<Reported> relative_cpu_time = {
    {0, 4.1, 0.0}, {1, 1.58, 0.0}, {3, 3.3, 0.0}, {17, 22.0, 0.0}};

/// Potential contacts per particle, section 5.
inline const std::vector<Reported> potential_contacts = {{0, 19.8, 0.0}};

} // namespace ellipsoid::post::paper
