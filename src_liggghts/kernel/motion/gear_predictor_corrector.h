// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Gear's predictor-corrector of fifth order for equations of second order, and what it needs to
// turn rigid bodies.
#pragma once

#include "motion/rigid_body.h"

#include <array>

namespace ellipsoid {

/// Second to fifth time derivative of one coordinate.
using GearDerivatives = std::array<double, 4>;

/// Advances a coordinate y with its rate and derivatives; y'' may depend on y and y'. Allen and
/// Tildesley, Computer Simulation of Liquids (1987), appendix E: prediction by Taylor's series,
/// then correction of each derivative in proportion to the error of the predicted second one.
class Gear {
 public:
  explicit Gear(double time_step) {
    double power = 1.0;
    for (int n = 1; n <= 5; ++n) {
      power *= time_step / n;
      term_[n] = power; // h^n / n!
    }
    // Table E.1, second order, six values; the first entry for forces that depend on velocities
    constexpr double scaled[6] = {3.0 / 16.0,  251.0 / 360.0, 1.0,
                                  11.0 / 18.0, 1.0 / 6.0,     1.0 / 60.0};
    for (int n = 0; n <= 5; ++n)
      gain_[n] = scaled[n] * term_[2] / term_[n];
  }

  void predict(double& y, double& rate, double* d) const {
    y += term_[1] * rate + term_[2] * d[0] + term_[3] * d[1] + term_[4] * d[2] + term_[5] * d[3];
    rate += term_[1] * d[0] + term_[2] * d[1] + term_[3] * d[2] + term_[4] * d[3];
    d[0] += term_[1] * d[1] + term_[2] * d[2] + term_[3] * d[3];
    d[1] += term_[1] * d[2] + term_[2] * d[3];
    d[2] += term_[1] * d[3];
  }

  /// @param[in] second y'' of the predicted y and rate
  void correct(double& y, double& rate, double* d, double second) const {
    const double error = second - d[0];
    y += gain_[0] * error;
    rate += gain_[1] * error;
    for (int k = 0; k < 4; ++k)
      d[k] += gain_[k + 2] * error;
  }

 private:
  std::array<double, 6> term_{{1.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
  std::array<double, 6> gain_{};
};

/// Rate of a quaternion (1/time) that belongs to an angular velocity (space frame).
inline Quaternion quaternion_rate(const Quaternion& q, const Vector3& omega) {
  return Quaternion{0.0, 0.5 * omega.x, 0.5 * omega.y, 0.5 * omega.z} * q;
}

/// Angular velocity (space frame) of a unit quaternion with this rate; a rate along the quaternion,
/// which would change its norm, does not count.
inline Vector3 angular_velocity_of_rate(const Quaternion& q, const Quaternion& rate) {
  const Quaternion w = rate * Quaternion{q.w, -q.x, -q.y, -q.z};
  return {2.0 * w.x, 2.0 * w.y, 2.0 * w.z};
}

/// Angular acceleration (space frame) by Euler's equations, Markauskas et al. 2010, eq. (12).
/// @param[in] omega, torque space frame
inline Vector3 angular_acceleration(const Quaternion& orientation, const Vector3& omega,
                                    const Vector3& torque, const Vector3& inertia) {
  const Rotation3 r = rotation(orientation);
  const Vector3 w = r.to_body(omega), t = r.to_body(torque);
  const Vector3 gyration = cross(w, Vector3{inertia.x * w.x, inertia.y * w.y, inertia.z * w.z});
  return r.to_space({(t.x - gyration.x) / inertia.x, (t.y - gyration.y) / inertia.y,
                     (t.z - gyration.z) / inertia.z});
}

/// Second derivative of a unit quaternion: that of its rate, q'' = omega' q / 2 - omega^2 q / 4.
inline Quaternion quaternion_acceleration(const Quaternion& q, const Vector3& omega,
                                          const Vector3& omega_rate) {
  const Quaternion turned = quaternion_rate(q, omega_rate);
  const double square = -0.25 * dot(omega, omega);
  return {turned.w + square * q.w, turned.x + square * q.x, turned.y + square * q.y,
          turned.z + square * q.z};
}

/// Second to fifth derivatives of the quaternion's w, x, y, z while the torque is constant in the
/// body frame (exact without torque): Taylor's series of Euler's equations and of q' = q omega / 2.
/// @param[in] omega, torque space frame
inline std::array<GearDerivatives, 4> rotation_derivatives(const Quaternion& orientation,
                                                           const Vector3& omega,
                                                           const Vector3& torque,
                                                           const Vector3& inertia) {
  const Rotation3 r = rotation(orientation);
  std::array<Vector3, 5> w{r.to_body(omega)}; // coefficients of the series, body frame
  constexpr Quaternion none{0.0, 0.0, 0.0, 0.0};
  std::array<Quaternion, 6> q{orientation, none, none, none, none, none};
  Vector3 moment = r.to_body(torque);
  std::array<GearDerivatives, 4> derivatives{};
  double factorial = 1.0;
  for (std::size_t n = 0; n < 5; ++n) {
    const double share = 1.0 / static_cast<double>(n + 1);
    for (std::size_t k = 0; k <= n; ++k) {
      const Vector3 &v = w[n - k], momentum{inertia.x * v.x, inertia.y * v.y, inertia.z * v.z};
      moment -= cross(w[k], momentum);
      const Quaternion part = q[k] * Quaternion{0.0, v.x, v.y, v.z};
      q[n + 1] = {q[n + 1].w + 0.5 * share * part.w, q[n + 1].x + 0.5 * share * part.x,
                  q[n + 1].y + 0.5 * share * part.y, q[n + 1].z + 0.5 * share * part.z};
    }
    if (n < 4)
      w[n + 1] = share * Vector3{moment.x / inertia.x, moment.y / inertia.y, moment.z / inertia.z};
    moment = {};
    factorial *= static_cast<double>(n + 1);
    if (n > 0) {
      const Quaternion& c = q[n + 1];
      const double values[4] = {c.w, c.x, c.y, c.z};
      for (std::size_t k = 0; k < 4; ++k)
        derivatives[k][n - 1] = factorial * values[k];
    }
  }
  return derivatives;
}

} // namespace ellipsoid
