// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Velocity-Verlet steps of many bodies in the xy plane.
#pragma once

#include "math/vector3.h"

namespace ellipsoid {

/// Rows of numbers, one row per body. Only bodies of the group move.
struct PlanarRows {
  double* centres;               ///< 3 each (length)
  double* velocities;            ///< 3 each (length/time)
  double* forces;                ///< 3 each (force)
  double* omega;                 ///< 3 each: angular velocities (rad/time)
  double* momenta;               ///< 3 each: angular momenta (mass length^2/time)
  double* torques;               ///< 3 each (force length)
  double* orientations;          ///< 4 each: unit quaternions
  const double* masses;          ///< (mass)
  const double* inverse_inertia; ///< 1 / moment of inertia about z (1 / (mass length^2))
  const int* groups;             ///< bits of the groups that the body is in
  int group;                     ///< its bit
};

/// First half of a step: kicks, moves and turns.
/// @param[in] time_step (time), @param[in] half_step half of it, in units of momentum over force
void start_planar_step(const PlanarRows& rows, int count, double time_step, double half_step);

/// Second half: kicks. Forces, torques and momenta out of the plane become 0: they are rounding, or
/// forces that do not count here.
void end_planar_step(const PlanarRows& rows, int count, double half_step);

} // namespace ellipsoid
