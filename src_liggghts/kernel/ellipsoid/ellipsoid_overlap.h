// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The overlap function phi(n) = s_i(n) + s_j(n) - n.d of two ellipsoids and its derivatives on the
// unit sphere: what the searches of ellipsoid_contact.cpp and contact_batch.cpp are made of. No
// branches here: loops over pairs become vector instructions. Vectors and matrices are those of
// space or those of the plane (plane.h).
#pragma once

#include "ellipsoid/contact_tolerances.h"
#include "math/plane.h"
#include "math/vector3.h"

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
template <class Vector> struct OverlapFunction {
  Vector normal;
  Vector support_point_i, support_point_j; // A n / s: farthest points along n (length)
  double inverse_support_i = 0.0, inverse_support_j = 0.0; // 1 / s (1 / length)
  double value = 0.0;                                      // phi (length)
  Vector gradient; // of the degree-one extension: n.gradient = phi (length)

  OverlapFunction() = default;

  template <class Matrix>
  OverlapFunction(const Matrix& a_i, const Matrix& a_j, const Vector& centre_distance,
                  const Vector& n)
      : normal(n) {
    const Vector farthest_i = a_i * n, farthest_j = a_j * n;
    const double support_i = std::sqrt(dot(n, farthest_i));
    const double support_j = std::sqrt(dot(n, farthest_j));
    const double inverse = 1.0 / (support_i * support_j); // one division
    inverse_support_i = support_j * inverse;
    inverse_support_j = support_i * inverse;
    support_point_i = inverse_support_i * farthest_i;
    support_point_j = inverse_support_j * farthest_j;
    value = support_i + support_j - dot(n, centre_distance);
    gradient = support_point_i + support_point_j - centre_distance;
  }

  /// Of phi on the sphere.
  Vector tangential_gradient() const { return gradient - value * normal; }

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

/// W_i + W_j, W = (A - (A n)(A n)^T / s^2) / s: radii of curvature (length). W n = 0: what happens
/// in the tangent plane needs no axes there.
inline SymmetricMatrix3 curvature_radii_sum(const SymmetricMatrix3& a_i,
                                            const SymmetricMatrix3& a_j,
                                            const OverlapFunction<Vector3>& f) {
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

inline PlaneMatrix curvature_radii_sum(const PlaneMatrix& a_i, const PlaneMatrix& a_j,
                                       const OverlapFunction<PlaneVector>& f) {
  const double w_i = f.inverse_support_i, w_j = f.inverse_support_j;
  const PlaneVector &p = f.support_point_i, &q = f.support_point_j;
  const PlaneVector u = w_i * p, v = w_j * q;
  return {w_i * a_i.xx - u.x * p.x + (w_j * a_j.xx - v.x * q.x),
          w_i * a_i.yy - u.y * p.y + (w_j * a_j.yy - v.y * q.y), w_i * a_i.zz + w_j * a_j.zz,
          w_i * a_i.xy - u.x * p.y + (w_j * a_j.xy - v.x * q.y)};
}

template <class Matrix> inline double trace(const Matrix& m) { return m.xx + m.yy + m.zz; }

/// Product of the two eigenvalues of a matrix whose third one is 0 (the sum of its minors).
inline double tangent_determinant(const SymmetricMatrix3& m) {
  return m.xx * m.yy - m.xy * m.xy + (m.xx * m.zz - m.xz * m.xz) + (m.yy * m.zz - m.yz * m.yz);
}

inline double tangent_determinant(const PlaneMatrix& m) {
  return m.xx * m.yy - m.xy * m.xy + m.xx * m.zz + m.yy * m.zz;
}

/// The Hessian of phi in the tangent plane, H = W_i + W_j - phi I.
template <class Matrix> struct OverlapHessian {
  Matrix radii; // W_i + W_j (length)
  double phi = 0.0, trace = 0.0, determinant = 0.0, inverse_determinant = 0.0;

  OverlapHessian() = default;

  OverlapHessian(const Matrix& radii_sum, double value)
      : radii(radii_sum), phi(value), trace(ellipsoid::trace(radii_sum) - 2.0 * value),
        determinant(tangent_determinant(radii_sum) - value * (ellipsoid::trace(radii_sum) - value)),
        inverse_determinant(1.0 / determinant) {}

  /// -H^-1 v of a vector in the tangent plane: there H^-1 = (tr H I - H) / det H.
  template <class Vector> Vector step(const Vector& v) const {
    return inverse_determinant * (radii * v - (trace + phi) * v);
  }

  /// Newton's step -H^-1 g (rad) with the tangential part g of the gradient.
  template <class Vector> Vector newton_shift(const OverlapFunction<Vector>& f) const {
    return step(f.tangential_gradient());
  }
};

/// What changes in one ellipsoid's support s and support point p from the normal n to the direction
/// n + t, with t tangent to n.
template <class Vector> struct SupportChange {
  double along;  ///< of s, first order: p.t (length)
  Vector first;  ///< of p, first order: W t (length)
  double bend;   ///< of s, twice the second order: t.(W t) (length)
  Vector second; ///< of p, second order: (dW/dt) t / 2 (length)

  template <class Matrix>
  SupportChange(const Matrix& a, const Vector& point, double inverse_support, const Vector& t)
      : along(dot(point, t)), first(inverse_support * (a * t - along * point)), bend(dot(t, first)),
        second(-inverse_support * (along * first + (0.5 * bend) * point)) {}

  /// Of s (length).
  double third_order(double inverse_support) const {
    return -0.5 * (along * bend * inverse_support);
  }
};

/// The minimum of phi near a normal, from derivatives there: Newton's step t, and Chebyshev's
/// correction -H^-1 (dH/dt) t / 2 of it (J. F. Traub, Iterative Methods for the Solution of
/// Equations, 1964). In directions n + t the support points alone bring terms of second order.
/// Errors are of third order of t, that of phi is of fourth. The gradient is not carried along.
/// When i and j are swapped only signs change, not a bit else.
/// @param[in] shift Newton's step (rad); 0: stays where it is
template <class Vector, class Matrix>
inline OverlapFunction<Vector> extrapolated(const Matrix& a_i, const Matrix& a_j,
                                            const OverlapFunction<Vector>& f,
                                            const OverlapHessian<Matrix>& h, const Vector& shift) {
  const SupportChange<Vector> i(a_i, f.support_point_i, f.inverse_support_i, shift),
      j(a_j, f.support_point_j, f.inverse_support_j, shift);
  const Vector bent = i.second + j.second;
  const Vector correction = h.step(bent - dot(bent, f.normal) * f.normal);
  const SupportChange<Vector> more_i(a_i, f.support_point_i, f.inverse_support_i, correction),
      more_j(a_j, f.support_point_j, f.inverse_support_j, correction);

  OverlapFunction<Vector> g = f;
  const Vector turned = f.normal + (shift + correction);
  g.normal = (1.5 - 0.5 * dot(turned, turned)) * turned; // what made it longer or shorter is undone
  g.value = f.value + 0.5 * dot(f.tangential_gradient(), shift) +
            (i.third_order(f.inverse_support_i) + j.third_order(f.inverse_support_j));
  g.support_point_i = f.support_point_i + (i.first + more_i.first + i.second);
  g.support_point_j = f.support_point_j + (j.first + more_j.first + j.second);
  const double support_i = dot(g.normal, g.support_point_i),
               support_j = dot(g.normal, g.support_point_j);
  const double inverse = 1.0 / (support_i * support_j);
  g.inverse_support_i = support_j * inverse;
  g.inverse_support_j = support_i * inverse;
  return g;
}

} // namespace ellipsoid
