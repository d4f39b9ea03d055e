// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Formulas of contact laws, each once: for the batch (law_batch.h) and for the host's contact
// models. They are functions of plain values without branches, so that loops over contacts become
// vector instructions, and templates over vectors of space and of the plane.
//
// Sign conventions: the unit normal points from j to i, as LIGGGHTS has it; velocities are those of
// i relative to j; forces act on i. The normal relative velocity is negative while the bodies
// approach.
#pragma once

#include "math/plane.h"
#include "math/vector3.h"

namespace ellipsoid {

/// A contact along its normal.
struct NormalContact {
  double overlap;         ///< h >= 0 (length)
  double reduced_radius;  ///< R of (19), (20) (length)
  double reduced_mass;    ///< m_ij = m_i m_j / (m_i + m_j)
  double normal_velocity; ///< (length/time)
};

/// What a normal law says of a contact.
struct NormalResponse {
  double force;                ///< F_n, positive where it pushes
  double stiffness;            ///< k_n: elastic part of the force over the overlap (force/length)
  double damping;              ///< eta_n m_ij (mass/time)
  double tangential_stiffness; ///< k_t of the tangential spring (force/length)
  double tangential_damping;   ///< for tangential laws that take it from here (mass/time)
};

/// A spring and a dashpot: (23) of Markauskas et al. 2010 along the normal.
inline NormalResponse spring_and_dashpot(const NormalContact& c, double stiffness, double damping,
                                         double tangential_stiffness, double tangential_damping) {
  return {stiffness * c.overlap - damping * c.normal_velocity, stiffness, damping,
          tangential_stiffness, tangential_damping};
}

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

/// @tparam Vector of space or of the plane (math/plane.h)
template <class Vector = Vector3> struct TangentialContact {
  double stiffness;         ///< of the spring (force/length)
  double damping;           ///< eta_t m_ij (mass/time)
  double friction_limit;    ///< mu |F_n| (force)
  Vector relative_velocity; ///< tangential (length/time)
};

/// Force on i by (24), and the spring shortened to what friction bears.
/// @param[in,out] spring accumulated tangential displacement (18), in the tangent plane (length)
template <SlipDirection direction, class Vector>
inline Vector friction(const TangentialContact<Vector>& c, Vector& spring) {
  const Vector viscous = c.damping * c.relative_velocity;
  const Vector trial = -c.stiffness * spring - viscous;
  const double magnitude = norm(trial);
  const bool slips = magnitude > c.friction_limit;
  if constexpr (direction == SlipDirection::velocity) {
    const double elastic = c.stiffness * norm(spring), speed = norm(c.relative_velocity);
    spring = (elastic > c.friction_limit ? c.friction_limit / elastic : 1.0) * spring;
    const double limited = slips ? c.friction_limit : magnitude; // eq. 24: min(|...|, mu |F_n|)
    return (speed > 0.0 ? -limited / speed : 0.0) * c.relative_velocity;
  }
  const Vector force = (slips ? c.friction_limit / magnitude : 1.0) * trial; // eq. 24
  // the spring that together with the present damping gives just this force
  spring = chosen(slips & (c.stiffness > 0.0), (-1.0 / c.stiffness) * (force + viscous), spring);
  return force;
}

/// The spring of the last step, carried on: grown by this step's slip (18), and turned into the
/// present tangent plane without change of length.
template <class Vector>
inline void advance_spring(Vector& spring, const Vector& relative_velocity, double time_step,
                           const Vector& normal) {
  const Vector in_plane = spring - dot(spring, normal) * normal;
  const double squared_length = dot(spring, spring), remaining = dot(in_plane, in_plane);
  const double stretch = std::sqrt(squared_length / (remaining > 0.0 ? remaining : 1.0));
  spring = (remaining > 0.0 ? stretch : 1.0) * in_plane + time_step * relative_velocity; // eq. 18
}

} // namespace ellipsoid
