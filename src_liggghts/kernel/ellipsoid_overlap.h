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

/// Symmetric 2x2 matrix in a tangent plane.
struct TangentMatrix {
  double xx = 0.0, xy = 0.0, yy = 0.0;
  double trace() const { return xx + yy; }
  double determinant() const { return xx * yy - xy * xy; }
};

/// phi and its first derivatives at one normal.
struct OverlapFunction {
  Vector3 normal;
  Vector3 support_point_i, support_point_j; // A n / s: farthest points along n (length)
  double support_i = 0.0, support_j = 0.0;
  double value = 0.0; // phi (length)
  Vector3 gradient;   // of the degree-one extension: n.gradient = phi (length)

  OverlapFunction() = default;

  OverlapFunction(const SymmetricMatrix3& a_i, const SymmetricMatrix3& a_j,
                  const Vector3& centre_distance, const Vector3& n)
      : normal(n) {
    const Vector3 farthest_i = a_i * n, farthest_j = a_j * n;
    support_i = std::sqrt(dot(n, farthest_i));
    support_j = std::sqrt(dot(n, farthest_j));
    support_point_i = (1.0 / support_i) * farthest_i;
    support_point_j = (1.0 / support_j) * farthest_j;
    value = support_i + support_j - dot(n, centre_distance);
    gradient = support_point_i + support_point_j - centre_distance;
  }

  /// Relative change of the radii of curvature per radian that n turns, as an upper estimate:
  /// W ~ 1 / s^3, and s changes by the tangential part of the support point.
  double radius_change_rate() const {
    const double slope_i = dot(support_point_i, support_point_i) / (support_i * support_i) - 1.0;
    const double slope_j = dot(support_point_j, support_point_j) / (support_j * support_j) - 1.0;
    const double larger = slope_i > slope_j ? slope_i : slope_j;
    return 1.0 + 3.0 * std::sqrt(larger > 0.0 ? larger : 0.0);
  }

  /// Length below which differences of `value` are noise.
  double noise() const {
    return tolerance::rounding_noise *
           (norm(support_point_i) + norm(support_point_j) + std::fabs(value));
  }
};

/// W_i + W_j in the tangent frame, W = (A - (A n)(A n)^T / s^2) / s: radii of curvature (length).
inline TangentMatrix curvature_radii_sum(const SymmetricMatrix3& a_i, const SymmetricMatrix3& a_j,
                                         const OverlapFunction& f, const TangentFrame& t) {
  const double w_i = 1.0 / f.support_i, w_j = 1.0 / f.support_j;
  const SymmetricMatrix3 a = w_i * a_i + w_j * a_j;
  const Vector3 a_first = a * t.first, a_second = a * t.second;
  const double i1 = dot(t.first, f.support_point_i), i2 = dot(t.second, f.support_point_i);
  const double j1 = dot(t.first, f.support_point_j), j2 = dot(t.second, f.support_point_j);
  return {dot(t.first, a_first) - w_i * i1 * i1 - w_j * j1 * j1,
          dot(t.first, a_second) - w_i * i1 * i2 - w_j * j1 * j2,
          dot(t.second, a_second) - w_i * i2 * i2 - w_j * j2 * j2};
}

/// The overlap function one very small step further: normal, supports and support points to second
/// order of the step, the overlap to third. The gradient is not carried along.
/// @param[in] shift tangent to the normal (rad)
/// @param[in] slope of phi along the step (length)
inline OverlapFunction extrapolated(const SymmetricMatrix3& a_i, const SymmetricMatrix3& a_j,
                                    const OverlapFunction& f, const Vector3& shift, double slope) {
  const double along_i = dot(f.support_point_i, shift), along_j = dot(f.support_point_j, shift);
  OverlapFunction g;
  g.normal = (1.0 / std::sqrt(1.0 + dot(shift, shift))) * (f.normal + shift);
  g.support_point_i = f.support_point_i +
                      (1.0 / f.support_i) * (a_i * shift - along_i * f.support_point_i); // W shift
  g.support_point_j =
      f.support_point_j + (1.0 / f.support_j) * (a_j * shift - along_j * f.support_point_j);
  g.support_i = f.support_i + along_i;
  g.support_j = f.support_j + along_j;
  g.value = f.value + 0.5 * slope;
  return g;
}

} // namespace ellipsoid
