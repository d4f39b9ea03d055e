// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The overlap function phi(n) = s_i(n) + s_j(n) - n.d of two ellipsoids and its derivatives on the
// unit sphere: what the searches of ellipsoid_contact.cpp and contact_batch.cpp are made of. No
// branches here: loops over pairs become vector instructions.
#pragma once

#include "contact_tolerances.h"
#include "vector3.h"

#include <cmath>

namespace ellipsoid {

/// Two unit vectors that make a right-handed frame with the unit vector n; no square root and
/// no branch but a sign (Duff et al. 2017, J. Comput. Graph. Tech. 6(1), listing 3).
struct TangentFrame {
  Vector3 first, second;

  explicit TangentFrame(const Vector3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double p = -1.0 / (sign + n.z);
    const double q = n.x * n.y * p;
    first = {1.0 + sign * n.x * n.x * p, sign * q, -sign * n.x};
    second = {q, sign + n.y * n.y * p, -n.y};
  }
};

/// phi and its first derivatives at one normal.
struct OverlapFunction {
  Vector3 normal;
  Vector3 support_point_i, support_point_j; // A n / s: farthest points along n (length)
  double inverse_support_i = 0.0, inverse_support_j = 0.0; // 1 / s (1 / length)
  double value = 0.0;                                      // phi (length)
  Vector3 gradient; // of the degree-one extension: n.gradient = phi (length)

  OverlapFunction() = default;

  OverlapFunction(const SymmetricMatrix3& a_i, const SymmetricMatrix3& a_j,
                  const Vector3& centre_distance, const Vector3& n)
      : normal(n) {
    const Vector3 farthest_i = a_i * n, farthest_j = a_j * n;
    const double support_i = std::sqrt(dot(n, farthest_i));
    const double support_j = std::sqrt(dot(n, farthest_j));
    inverse_support_i = 1.0 / support_i;
    inverse_support_j = 1.0 / support_j;
    support_point_i = inverse_support_i * farthest_i;
    support_point_j = inverse_support_j * farthest_j;
    value = support_i + support_j - dot(n, centre_distance);
    gradient = support_point_i + support_point_j - centre_distance;
  }

  /// Relative change of the radii of curvature per radian that n turns, as an upper estimate:
  /// W ~ 1 / s^3, and s changes by the tangential part of the support point, t s per radian;
  /// 3 t <= 3 (1 + t^2) / 2, where 1 + t^2 is the squared distance of that point over s^2.
  double radius_change_rate() const {
    const double i = dot(support_point_i, support_point_i) * inverse_support_i * inverse_support_i;
    const double j = dot(support_point_j, support_point_j) * inverse_support_j * inverse_support_j;
    return 1.0 + 1.5 * (i > j ? i : j);
  }

  /// Length below which differences of `value` are noise.
  double noise() const {
    return tolerance::rounding_noise *
           (norm(support_point_i) + norm(support_point_j) + std::fabs(value));
  }
};

/// W_i + W_j, W = (A - (A n)(A n)^T / s^2) / s: radii of curvature (length). W n = 0: what happens in
/// the tangent plane needs no axes there.
inline SymmetricMatrix3 curvature_radii_sum(const SymmetricMatrix3& a_i,
                                            const SymmetricMatrix3& a_j,
                                            const OverlapFunction& f) {
  const double w_i = f.inverse_support_i, w_j = f.inverse_support_j;
  const Vector3 &p = f.support_point_i, &q = f.support_point_j;
  const Vector3 u = w_i * p, v = w_j * q;
  return {w_i * a_i.xx - u.x * p.x + (w_j * a_j.xx - v.x * q.x),
          w_i * a_i.yy - u.y * p.y + (w_j * a_j.yy - v.y * q.y),
          w_i * a_i.zz - u.z * p.z + (w_j * a_j.zz - v.z * q.z),
          w_i * a_i.xy - u.x * p.y + (w_j * a_j.xy - v.x * q.y),
          w_i * a_i.xz - u.x * p.z + (w_j * a_j.xz - v.x * q.z),
          w_i * a_i.yz - u.y * p.z + (w_j * a_j.yz - v.y * q.z)};
}

inline double trace(const SymmetricMatrix3& m) { return m.xx + m.yy + m.zz; }

/// Product of the two eigenvalues of a matrix whose third one is 0 (the sum of its minors).
inline double tangent_determinant(const SymmetricMatrix3& m) {
  return m.xx * m.yy - m.xy * m.xy + (m.xx * m.zz - m.xz * m.xz) + (m.yy * m.zz - m.yz * m.yz);
}

/// The Hessian of phi in the tangent plane, H = W_i + W_j - phi I.
struct OverlapHessian {
  SymmetricMatrix3 radii; // W_i + W_j (length)
  double phi, trace, determinant;

  OverlapHessian(const SymmetricMatrix3& radii_sum, double value)
      : radii(radii_sum), phi(value), trace(ellipsoid::trace(radii_sum) - 2.0 * value),
        determinant(tangent_determinant(radii_sum) -
                    value * (ellipsoid::trace(radii_sum) - value)) {}

  /// Newton's step -H^-1 g (rad) with the tangential part g of the gradient: in a plane
  /// H^-1 = (tr H I - H) / det H.
  /// @param[in] inverse 1 / det H
  Vector3 newton_shift(const OverlapFunction& f, double inverse) const {
    const Vector3 tangential = f.gradient - f.value * f.normal;
    return inverse * (radii * tangential - (trace + phi) * tangential);
  }
};

/// The overlap function one very small step further: normal, supports and support points to second
/// order of the step, the overlap to third. The gradient is not carried along.
/// @param[in] shift tangent to the normal (rad)
/// @param[in] slope of phi along the step (length)
inline OverlapFunction extrapolated(const SymmetricMatrix3& a_i, const SymmetricMatrix3& a_j,
                                    const OverlapFunction& f, const Vector3& shift, double slope) {
  const double along_i = dot(f.support_point_i, shift), along_j = dot(f.support_point_j, shift);
  const double growth_i = along_i * f.inverse_support_i, growth_j = along_j * f.inverse_support_j;
  OverlapFunction g;
  g.normal = (1.0 - 0.5 * dot(shift, shift)) * (f.normal + shift);
  g.support_point_i = f.support_point_i + f.inverse_support_i * (a_i * shift) -
                      growth_i * f.support_point_i; // W shift
  g.support_point_j =
      f.support_point_j + f.inverse_support_j * (a_j * shift) - growth_j * f.support_point_j;
  g.inverse_support_i = f.inverse_support_i * (1.0 - growth_i + growth_i * growth_i);
  g.inverse_support_j = f.inverse_support_j * (1.0 - growth_j + growth_j * growth_j);
  g.value = f.value + 0.5 * slope;
  return g;
}

} // namespace ellipsoid
