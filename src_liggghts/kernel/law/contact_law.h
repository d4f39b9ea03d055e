// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The visco-elastic contact law with friction of Markauskas et al. 2010, eqs. (23) and (24).
//
// Sign conventions: the unit normal points from j to i, as LIGGGHTS has it; velocities are those of
// i relative to j; forces act on i. The normal relative velocity is negative while the bodies
// approach.
#pragma once

#include "math/vector3.h"

namespace ellipsoid {

/// Elastic part of (23), force over overlap (force/length). For like materials
/// E* = E / (2 (1 - nu^2)) and the force is 2/3 E/(1-nu^2) sqrt(R h^3).
/// @param[in] effective_modulus E*, 1/E* = (1-nu_i^2)/E_i + (1-nu_j^2)/E_j (pressure)
/// @param[in] sqrt_radius_overlap sqrt(R h) (length)
inline double normal_stiffness(double effective_modulus, double sqrt_radius_overlap) {
  return 4.0 / 3.0 * effective_modulus * sqrt_radius_overlap; // Markauskas et al. 2010, eq. 23
}

/// Stiffness of the tangential spring of (24) (force/length). For like materials
/// G* = G / (2 (2 - nu)) and the stiffness is 8/3 G sqrt(R h)/(2 - nu).
/// @param[in] effective_shear_modulus G*, 1/G* = 2(2-nu_i)/G_i + 2(2-nu_j)/G_j over 2 (pressure)
/// @param[in] sqrt_radius_overlap sqrt(R h) (length)
inline double tangential_stiffness(double effective_shear_modulus, double sqrt_radius_overlap) {
  return 16.0 / 3.0 * effective_shear_modulus * sqrt_radius_overlap; // eq. 24
}

/// Which way t of (24) points.
enum class SlipDirection {
  displacement, ///< along the accumulated displacement: the usual spring
  velocity      ///< along the present tangential velocity: a resting contact creeps
};

struct TangentialContact {
  double stiffness;          ///< of the spring (force/length)
  double damping;            ///< eta_t m_ij (mass/time)
  double friction_limit;     ///< mu |F_n| (force)
  Vector3 relative_velocity; ///< tangential (length/time)
};

/// Force on i by (24), and the spring shortened to what friction bears.
/// @param[in,out] spring accumulated tangential displacement (18), in the tangent plane (length)
inline Vector3 tangential_force(SlipDirection direction, const TangentialContact& c,
                                Vector3& spring) {
  const Vector3 trial = -c.stiffness * spring - c.damping * c.relative_velocity;
  const double magnitude = norm(trial);
  const bool slips = magnitude > c.friction_limit;
  const double limited = slips ? c.friction_limit : magnitude; // eq. 24: min(|...|, mu |F_n|)
  if (direction == SlipDirection::velocity) {
    const double elastic = c.stiffness * norm(spring);
    if (elastic > c.friction_limit)
      spring *= c.friction_limit / elastic;
    const double speed = norm(c.relative_velocity);
    return speed > 0.0 ? (-limited / speed) * c.relative_velocity : Vector3{};
  }
  if (!slips)
    return trial;
  const Vector3 force = (limited / magnitude) * trial;
  // the spring that together with the present damping gives just this force
  if (c.stiffness > 0.0)
    spring = (-1.0 / c.stiffness) * (force + c.damping * c.relative_velocity);
  return force;
}

/// The spring of the last step, carried on: grown by this step's slip (18), and turned into the
/// present tangent plane without change of length.
inline void advance_spring(Vector3& spring, const Vector3& relative_velocity, double time_step,
                           const Vector3& normal) {
  const double squared_length = dot(spring, spring);
  if (squared_length > 0.0) {
    spring -= dot(spring, normal) * normal;
    const double remaining = dot(spring, spring);
    if (remaining > 0.0)
      spring *= std::sqrt(squared_length / remaining);
  }
  spring += time_step * relative_velocity; // eq. 18
}

} // namespace ellipsoid
