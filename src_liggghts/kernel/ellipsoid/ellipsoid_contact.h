// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contact of two ellipsoids, and of an ellipsoid with a plane, by support functions.
//
// With A = R diag(a^2, b^2, c^2) R^T the support function of an ellipsoid is
//   s(n) = sqrt(n^T A n)                                            (length),
// and the signed overlap of i and j, d = x_j - x_i, is the minimum over unit n of
//   phi(n) = s_i(n) + s_j(n) - n.d                                  (length).
// A negative value for ANY n proves separation. The minimum is found by Newton's method on the
// sphere (two unknowns); the tangent-plane second derivatives W of s are the tensors of the
// radii of curvature, so the Hessian of phi is W_i + W_j - phi I.
//
// Conventions, used everywhere in the kernel:
//  - lengths in any consistent unit; nothing here has an absolute length scale;
//  - the normal n points from body i to body j (out of i);
//  - the overlap h is positive when the bodies penetrate, negative when they are apart
//    (then -h is their distance);
//  - the contact point lies in the middle of the overlap, on the common normal.
#pragma once

#include "ellipsoid/contact_tolerances.h"
#include "ellipsoid/elliptic_hertz.h"
#include "math/vector3.h"

#include <algorithm>

namespace ellipsoid {

/// An ellipsoid about the origin of its own frame, ready for contact evaluation; one cache line.
struct alignas(64) EllipsoidShape {
  SymmetricMatrix3 a_matrix;             ///< A = R diag(a^2, b^2, c^2) R^T (length^2)
  double axes_product = 0.0;             ///< a b c (length^3)
  double smallest_curvature_radius = 0.; ///< min(a,b,c)^2 / max(a,b,c) (length)
};

/// @param[in] semiaxes    a, b, c along the body's x, y, z (length, > 0)
/// @param[in] orientation unit quaternion, body to space
inline EllipsoidShape make_shape(const Vector3& semiaxes, const Quaternion& orientation) {
  const double aa = semiaxes.x * semiaxes.x, bb = semiaxes.y * semiaxes.y,
               cc = semiaxes.z * semiaxes.z;
  EllipsoidShape shape;
  shape.a_matrix = rotated_diagonal(rotation(orientation), aa, bb, cc);
  shape.axes_product = semiaxes.x * semiaxes.y * semiaxes.z;
  shape.smallest_curvature_radius =
      std::min(std::min(aa, bb), cc) / std::max(std::max(semiaxes.x, semiaxes.y), semiaxes.z);
  return shape;
}

enum class ContactStatus {
  separated,     ///< a separating normal was found: proof that the bodies do not touch
  touching,      ///< converged, overlap >= 0
  not_converged, ///< iteration limit: the geometry is the best found; callers count and report it
  not_a_pose ///< a centre, axis or orientation is NaN or infinite, and so may be what is returned
};

inline bool has_converged(ContactStatus status) {
  return status == ContactStatus::separated || status == ContactStatus::touching;
}

struct ContactGeometry {
  ContactStatus status = ContactStatus::separated;
  Vector3 normal;                  ///< unit, from i to j
  Vector3 point;                   ///< contact point, relative to the centre of i (length)
  double overlap = 0.0;            ///< h (length)
  double reduced_radius = 0.0;     ///< R of (19) (length)
  double curvature_radius_i = 0.0; ///< sqrt(det W_i): Gaussian radius of i at the contact (length)
  double curvature_radius_j = 0.0; ///< the same of j; infinity for a plane
  int iterations = 0;              ///< Newton steps
};

/// When the search may stop.
enum class SearchGoal {
  contact, ///< at the first separating normal: `overlap` is then only a lower bound of the distance
  distance ///< never before convergence: the exact distance of separated bodies, too
};

struct SearchOptions {
  SearchGoal goal = SearchGoal::contact;
  int newton_limit = tolerance::newton_limit;
};

/// Contact of i with j from scratch: safe for any pose, size and aspect ratio.
/// @param[in] centre_distance x_j - x_i (length)
ContactGeometry find_contact(const EllipsoidShape& i, const EllipsoidShape& j,
                             const Vector3& centre_distance, const SearchOptions& options = {});

/// The same, started from a unit normal known from an earlier moment.
ContactGeometry find_contact_from(const Vector3& normal_guess, const EllipsoidShape& i,
                                  const EllipsoidShape& j, const Vector3& centre_distance,
                                  const SearchOptions& options = {});

/// Whether a descent from one normal found the answer. A minimum of phi not deeper than the
/// smallest radius of curvature of the Minkowski sum is the only one below that depth: a ball of
/// that radius rolls freely inside the sum (Blaschke). A deeper one has to be searched from many
/// normals.
bool is_settled(const ContactGeometry& found, const EllipsoidShape& i, const EllipsoidShape& j);

/// Support function s(n) = sqrt(n^T A n) (length); n need not be a unit vector.
inline double support(const EllipsoidShape& shape, const Vector3& normal) {
  return std::sqrt(dot(normal, shape.a_matrix * normal));
}

/// phi(n) = s_i(n) + s_j(n) - n.d: a negative value for any unit n proves separation.
inline double overlap_along(const EllipsoidShape& i, const EllipsoidShape& j,
                            const Vector3& centre_distance, const Vector3& normal) {
  return support(i, normal) + support(j, normal) - dot(normal, centre_distance);
}

/// A and B of the gap of two bodies that touch with this unit normal (from i to j); for laws that
/// need more of the curvatures than (19).
RelativeCurvature relative_curvature(const EllipsoidShape& i, const EllipsoidShape& j,
                                     const Vector3& normal);
/// The same with a plane.
RelativeCurvature relative_curvature(const EllipsoidShape& i, const Vector3& normal);

/// Whether an ellipsoid reaches as far as a plane, or nearly (by a share of 1e-9): cheaper than
/// find_plane_contact(), of which most bodies near a wall need no more.
/// @param[in] semiaxes a, b, c along the body's x, y, z (length), @param[in] orientation unit
/// quaternion
/// @param[in] normal unit, to the plane, @param[in] distance of the plane from the centre (length)
inline bool may_touch_plane(const Vector3& semiaxes, const Quaternion& orientation,
                            const Vector3& normal, double distance) {
  const Vector3 n = rotation(orientation).to_body(normal);
  const Vector3 reach{semiaxes.x * n.x, semiaxes.y * n.y, semiaxes.z * n.z};
  constexpr double margin = 1e-9;
  return !(dot(reach, reach) < (1.0 - margin) * distance * distance);
}

/// Contact with the plane through `plane_point` (relative to the centre of i) with unit
/// `plane_normal` pointing from the body into the wall. Closed form.
ContactGeometry find_plane_contact(const EllipsoidShape& i, const Vector3& plane_point,
                                   const Vector3& plane_normal);

} // namespace ellipsoid
