// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the surfaces of many particles did in a step, from where they are and where they were.
//
// In a step a particle is displaced with its centre, and turns by the angle between its two
// orientations, whatever moved it. What counts is how far it reaches in a direction: when it turns
// by an angle, that changes by at most the angle times the difference of the largest and the
// smallest semi-axis.
#pragma once

#include "multisphere/multisphere_contact.h"
#include "separation/motion_clocks.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid {

/// Upper bound of the angle between two orientations (rad), from the distance of their unit
/// quaternions, 2 sin(angle / 4): 4 asin(d / 2) <= 2.05 d up to d = 0.5, <= pi d always.
inline double largest_angle(double quaternion_distance) {
  constexpr double half_turn = 3.14159265358979323846;
  return (quaternion_distance < 0.5 ? 2.05 : half_turn) * quaternion_distance;
}

/// Rows of numbers, one row per particle.
struct PoseRows {
  const double* turning_radii; ///< (length)
  const double* centres;       ///< 3 each (length)
  const double* orientations;  ///< 4 each: unit quaternion
  double* last_centres;        ///< a step ago; become `centres`
  double* last_orientations;   ///< a step ago; become `orientations`
};

/// @param[in,out] motions of `motions.count` particles
void measure_motions(const PoseRows& poses, Motions& motions);

/// The same of chains of spheres.
struct MultisphereRows {
  const double* semiaxes;     ///< 3 each: the second is the chain's scale (length)
  const double* centres;      ///< 3 each (length)
  const double* orientations; ///< 4 each: unit quaternion
  double* last_centres;       ///< a step ago; become `centres`
  MultispherePose* poses;     ///< a step ago; become those of now
};
void measure_motions(const MultisphereRows& chains, Motions& motions);

} // namespace ellipsoid
