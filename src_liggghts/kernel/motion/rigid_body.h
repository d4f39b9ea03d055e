// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Free rotation of a rigid body, eqs. (12) and (13) of Markauskas et al. 2010, with quaternions.
#pragma once

#include "math/vector3.h"

namespace ellipsoid {

/// One over each of the principal moments (mass length^2, about the body's x, y, z): what particles
/// need at every step and have for a long time.
inline Vector3 inverse(const Vector3& inertia) {
  return {1.0 / inertia.x, 1.0 / inertia.y, 1.0 / inertia.z};
}

/// Angular velocity (rad/time, space frame) that belongs to an angular momentum (space frame).
/// @param[in] inverse_inertia inverse() of the principal moments
inline Vector3 angular_velocity_by_inverse(const Vector3& momentum, const Vector3& inverse_inertia,
                                           const Quaternion& orientation) {
  // a sphere's, by the moment about z, and what the two other axes have more
  const Rotation3 r = rotation(orientation);
  const double more_x = (inverse_inertia.x - inverse_inertia.z) * dot(r.column_x, momentum);
  const double more_y = (inverse_inertia.y - inverse_inertia.z) * dot(r.column_y, momentum);
  return inverse_inertia.z * momentum + more_x * r.column_x + more_y * r.column_y;
}

/// Angular velocity (rad/time, space frame) of a body with principal moments `inertia`
/// (mass length^2, about the body's x, y, z) and angular momentum `momentum` (space frame).
inline Vector3 angular_velocity(const Vector3& momentum, const Vector3& inertia,
                                const Quaternion& orientation) {
  return angular_velocity_by_inverse(momentum, inverse(inertia), orientation);
}

/// Angular momentum (space frame) that belongs to an angular velocity (space frame).
inline Vector3 angular_momentum(const Vector3& omega, const Vector3& inertia,
                                const Quaternion& orientation) {
  const Rotation3 r = rotation(orientation);
  const Vector3 w = r.to_body(omega);
  return r.to_space({w.x * inertia.x, w.y * inertia.y, w.z * inertia.z});
}

/// Rotational kinetic energy (energy) at an angular momentum (space frame).
inline double rotational_energy(const Vector3& momentum, const Vector3& inertia,
                                const Quaternion& orientation) {
  return 0.5 * dot(momentum, angular_velocity(momentum, inertia, orientation));
}

namespace detail {

/// Turns about one body axis by the angle whose half has the tangent `half`: the rational (Cayley)
/// rotation, of second order in the angle. `p`, `q` are the momentum's components along the two
/// other axes in cyclic order, whose length is kept exactly; `a` is the quaternion's component of
/// the turned axis, `b`, `c` those of the others in the same order: its norm grows by sqrt(1 +
/// half^2).
inline void turn(double half, double& p, double& q, double& w, double& a, double& b, double& c) {
  const double sine = 2.0 * half / (1.0 + half * half); // cosine: 1 - half sine
  const double p_new = p + sine * (q - half * p), q_new = q - sine * (p + half * q);
  p = p_new;
  q = q_new;
  const double w_new = w - half * a, a_new = a + half * w;
  const double b_new = b + half * c, c_new = c - half * b;
  w = w_new;
  a = a_new;
  b = b_new;
  c = c_new;
}

} // namespace detail

/// A torque-free body in the midst of a step: symmetric splitting into turns about the body's axes
/// (as Miller et al. 2002, J. Chem. Phys. 116, 8649, order z y x y z), each with its constant
/// component of the angular momentum. Second order, time-reversible; angular momentum and the
/// quaternion's norm are kept exactly. `rate`: inverse() of the principal moments.
struct FreeRotation {
  Quaternion q;
  Vector3 m; ///< angular momentum, body frame

  /// The first turns.
  void turn_zy(const Vector3& rate, double time_step) {
    turn_z(rate, time_step);
    turn_y(rate, time_step);
  }
  /// The last ones.
  void turn_xyz(const Vector3& rate, double time_step) {
    detail::turn(0.5 * time_step * rate.x * m.x, m.y, m.z, q.w, q.x, q.y, q.z);
    turn_y(rate, time_step);
    turn_z(rate, time_step);
  }
  /// In the space frame.
  Vector3 omega(const Vector3& rate) const {
    return rotation(q).to_space({m.x * rate.x, m.y * rate.y, m.z * rate.z});
  }

 private:
  void turn_z(const Vector3& rate, double time_step) {
    detail::turn(0.25 * time_step * rate.z * m.z, m.x, m.y, q.w, q.z, q.x, q.y);
  }
  void turn_y(const Vector3& rate, double time_step) {
    detail::turn(0.25 * time_step * rate.y * m.y, m.z, m.x, q.w, q.y, q.z, q.x);
  }
};

/// Moment of inertia about the space z axis, and how far z is from a principal axis.
struct PlanarInertia {
  /// The principal moment itself (mass length^2): rounding of the orientation leaves no trace in
  /// it.
  double about_z;
  double misaligned; ///< sine^2 of the angle between z and I z: 0 for every principal axis, also
                     ///< for any across the symmetry axis of a body with two equal moments
};

/// For bodies with a principal axis along z, which `misaligned` tells.
inline PlanarInertia planar_inertia(const Quaternion& orientation, const Vector3& inertia) {
  const Vector3 z = rotation(orientation).to_body({0.0, 0.0, 1.0});
  const Vector3 momentum{inertia.x * z.x, inertia.y * z.y, inertia.z * z.z};
  const Vector3 across = cross(z, momentum);
  // z lies along one axis, or between axes of equal moments: the first with more than this share of
  // z. No common angle is near the limit, so that rounding does not change the choice.
  const double share = 0.31 * dot(z, z);
  const double about_z = z.x * z.x > share ? inertia.x : z.y * z.y > share ? inertia.y : inertia.z;
  return {about_z, dot(across, across) / dot(momentum, momentum)};
}

} // namespace ellipsoid
