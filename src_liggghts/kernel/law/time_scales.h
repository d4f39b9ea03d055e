// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Times that limit the time step: Rayleigh's and Hertz's, for bodies that also turn when they
// collide.
#pragma once

#include "math/vector3.h"
#include "multisphere/multisphere_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ellipsoid {

/// Time in which a Rayleigh wave runs half around a sphere of this radius: pi r sqrt(rho/G) /
/// (0.1631 nu + 0.8766); Thornton and Randall 1988, in the form of Li, Xu and Thornton, Powder
/// Technology 160 (2005) 219.
inline double rayleigh_time(double radius, double density, double shear_modulus,
                            double poissons_ratio) {
  return M_PI * radius * std::sqrt(density / shear_modulus) / (0.1631 * poissons_ratio + 0.8766);
}

/// Duration of an elastic collision, 2.87 (m*^2 / (R E*^2 v))^(1/5); Johnson, Contact Mechanics
/// (1985), eq. 11.24. @param[in] mass2_over_radius m*^2/R, m* the reduced mass at the contact
/// (mass^2/length)
inline double hertz_time(double mass2_over_radius, double effective_modulus, double speed) {
  return 2.87 * std::pow(mass2_over_radius / (effective_modulus * effective_modulus * speed), 0.2);
}

/// m*^2/R of a body that hits its like, both with the point at which they touch: R is half the
/// radius of curvature there, 1/m* twice the mobility along the normal, 1/m + (r x n).I^-1.(r x n).
inline double mass2_over_radius(double curvature, double mobility) {
  return 0.5 * curvature / (mobility * mobility);
}

/// The same for the points of an ellipsoid, with 1/R of (19) for two equal, aligned curvatures. In
/// the squares u of a point's coordinates over the semi-axes (u.x + u.y + u.z = 1), with
///   W = u.x / a^2 + u.y / b^2 + u.z / c^2,
///   Q = u.y u.z (b^2 - c^2)^2 / (b^2 c^2 I_x) + the same for the other two pairs of axes,
/// the root of Gauss's curvature is 1 / (a b c W), the mobility 1/m + Q/W, and hence
///   m*^2/R = 1 / (2 a b c S), S = (W/m + Q)^2 / W.
class CollisionSeverity {
 public:
  CollisionSeverity(const Vector3& semiaxes, double mass, const Vector3& inertia)
      : axes_product_(semiaxes.x * semiaxes.y * semiaxes.z), inverse_mass_(1.0 / mass) {
    const double aa = semiaxes.x * semiaxes.x, bb = semiaxes.y * semiaxes.y,
                 cc = semiaxes.z * semiaxes.z;
    const auto arm = [](double first, double second, double moment) {
      return (first - second) * (first - second) / (first * second * moment);
    };
    arms_ = {arm(bb, cc, inertia.x), arm(cc, aa, inertia.y), arm(aa, bb, inertia.z)};
    inverse_squares_ = {1.0 / aa, 1.0 / bb, 1.0 / cc};
  }

  double at(const Vector3& u) const { return between(u, u); }

  /// The quotient z^2 / W of the polar forms of z = W/m + Q and W at two points: where a piece of
  /// the surface has the corners u_k, those of all pairs of corners are its Bezier coefficients,
  /// and as z^2 / W is a convex function of z and W > 0, none of its values on the piece is larger
  /// than the largest of these.
  double between(const Vector3& u, const Vector3& v) const {
    const double w = 0.5 * dot(inverse_squares_, u + v);
    const double q = 0.5 * (arms_.x * (u.y * v.z + u.z * v.y) + arms_.y * (u.z * v.x + u.x * v.z) +
                            arms_.z * (u.x * v.y + u.y * v.x));
    const double z = inverse_mass_ * w + q;
    return z * z / w;
  }

  /// Corners of a piece of the surface that has all values of S: a side of it for a body of
  /// revolution, which has the same ones on its other sides.
  std::array<Vector3, 3> whole() const {
    const Vector3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
    const Vector3 &w = inverse_squares_, &q = arms_;
    if (w.y == w.z && q.x == 0.0 && q.y == q.z)
      return {x, y, y};
    if (w.z == w.x && q.y == 0.0 && q.z == q.x)
      return {y, z, z};
    if (w.x == w.y && q.z == 0.0 && q.x == q.y)
      return {z, x, x};
    return {x, y, z};
  }

  /// m*^2/R where S has that value (mass^2/length).
  double mass2_over_radius(double severity) const { return 0.5 / (axes_product_ * severity); }

 private:
  double axes_product_, inverse_mass_;
  Vector3 arms_, inverse_squares_;
};

/// The smallest value over all points of an ellipsoid, or up to 5e-5 less: where it is stiffest and
/// lightest at once. Pairs of unlike points or bodies lie between the values of the two: with k >=
/// C u^2 for both, (k1 + k2) / (u1 + u2)^2 >= C/2. By branch and bound: pieces of the surface that
/// cannot hold more than what is found are left out, the others are cut in four.
inline double smallest_mass2_over_radius(const Vector3& semiaxes, double mass,
                                         const Vector3& inertia) {
  constexpr double excess = 5e-5; // that the bound may have over the largest severity found
  const CollisionSeverity severity(semiaxes, mass, inertia);
  std::vector<std::array<Vector3, 3>> pieces{severity.whole()}, rest;
  double largest = 0.0, bound = 0.0;
  for (; !pieces.empty(); pieces.swap(rest), rest.clear()) {
    for (const auto& piece : pieces)
      for (const Vector3& u : piece)
        largest = std::max(largest, severity.at(u));
    for (const auto& [a, b, c] : pieces) {
      const double most =
          std::max({severity.at(a), severity.at(b), severity.at(c), severity.between(a, b),
                    severity.between(b, c), severity.between(c, a)});
      if (most <= (1.0 + excess) * largest) {
        bound = std::max(bound, most);
        continue;
      }
      const Vector3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
      const bool is_side = norm(b - c) == 0.0;
      if (is_side)
        rest.insert(rest.end(), {{a, ab, ab}, {ab, b, b}});
      else
        rest.insert(rest.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
  }
  return severity.mass2_over_radius(bound);
}

/// Largest (r x n).I^-1.(r x n) over all directions n, for a point on the line of the force at r
/// from the centre: r x n is any vector across r up to |r|, so it is |r|^2 times the larger
/// eigenvalue of I^-1 in the plane across r, from its trace and determinant there.
inline double largest_arm(const Vector3& r, const Vector3& inertia) {
  const Vector3 inverse{1.0 / inertia.x, 1.0 / inertia.y, 1.0 / inertia.z};
  const double xx = r.x * r.x, yy = r.y * r.y, zz = r.z * r.z;
  const double trace =
      xx * (inverse.y + inverse.z) + yy * (inverse.z + inverse.x) + zz * (inverse.x + inverse.y);
  const double determinant =
      (xx + yy + zz) *
      (xx * inverse.y * inverse.z + yy * inverse.z * inverse.x + zz * inverse.x * inverse.y);
  return 0.5 * (trace + std::sqrt(std::max(0.0, trace * trace - 4.0 * determinant)));
}

/// The same for a body of spheres, each touched from the side where it turns the body most easily.
/// @param[in] inertia principal moments
inline double smallest_mass2_over_radius(const MultisphereBody& body, double scale, double mass,
                                         const Vector3& inertia) {
  double best = HUGE_VAL;
  for (int k = 0; k < body.count(); ++k)
    best = std::min(
        best, mass2_over_radius(1.0 / (scale * body.radius(k)),
                                1.0 / mass + scale * scale * largest_arm(body.centre(k), inertia)));
  return best;
}

} // namespace ellipsoid
