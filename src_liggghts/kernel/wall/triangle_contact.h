// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contact of a convex body (ellipsoid, or sphere of a chain) with one triangle of a wall.
//
// All positions are relative to the particle's centre. Conventions: ellipsoid_contact.h; the normal
// points from the body into the wall.
//
// With the body's support function s the overlap along n is phi(n) = s(n) - min over the triangle
// of n.p (length), as for two ellipsoids. Its minimum is one of:
//  - face: n is the plane's normal, if the body's deepest point lies above the triangle; the result
//    is then that of find_plane_contact();
//  - edge: n is normal to the edge, and phi the depth of a point of the edge below the body's
//    surface. Seen along the edge the body is an ellipse, its shadow, and n the normal at the
//    point of the shadow nearest to the edge;
//  - corner: n is the normal at the surface point nearest to the corner.
// Up to an overlap of the smallest radius of curvature there is one minimum only; of several the
// smallest counts. Where a body slides over an edge, n turns steadily from the normal of one face
// to that of the other and the overlap changes steadily.
#pragma once

#include "multisphere/multisphere_contact.h"
#include "wall/surface_points.h"
#include "wall/wall_contact.h"

#include <array>

namespace ellipsoid {

/// Corners of a triangle with area > 0, relative to the particle's centre (length).
using Triangle = std::array<Vector3, 3>;

enum class TriangleFeature { none, face, edge, corner };

struct TriangleContact : WallContact {
  TriangleFeature feature = TriangleFeature::none; ///< none: no contact
  bool deep = false;                               ///< overlap > smallest radius of curvature
};

/// One sphere of a chain.
struct SphereBody {
  Vector3 centre; ///< relative to the particle's centre (length)
  double radius = 0.0;
  int number = 0; ///< in the chain
  /// The way from the particle's centre to the sphere's leads through a wall: then the particle's
  /// centre tells which side is in front, else the sphere's own.
  bool beyond_wall = false;
};

/// Minima of phi: at the face, and the smallest of those at edges and corners.
struct TriangleContacts {
  TriangleContact face, boundary;
  /// The body reaches beyond the plane and its deepest point lies above the triangle, but it does
  /// not reach the triangle itself: a contact only if it reaches the same plane on another
  /// triangle.
  bool face_is_missed = false;
  bool plane_is_reached = false;
  /// There may be a minimum at an edge or corner: the plane is reached, and that at the face is not
  /// certainly the only one.
  bool boundary_may_touch = false;
};

/// All but the boundary. The particle's centre tells which side of the plane is in front.
TriangleContacts find_face_contact(const EllipsoidBody& body, const Triangle& triangle);
TriangleContacts find_face_contact(const SphereBody& body, const Triangle& triangle);

/// The boundary, where it may touch.
TriangleContact find_boundary_contact(const EllipsoidBody& body, const Triangle& triangle);
TriangleContact find_boundary_contact(const SphereBody& body, const Triangle& triangle);

/// Contact at the triangle's point that the body reaches first when it grows about its centre from
/// nothing: defined for any depth, but at edges and corners the overlap is phi at a normal that
/// differs from the minimum's by an angle of the order overlap / radius of curvature.
/// @param[out] growth the factor at which it is reached; contact if < 1
TriangleContact find_growing_contact(const EllipsoidBody& body, const Triangle& triangle,
                                     double& growth);
TriangleContact find_growing_contact(const SphereBody& body, const Triangle& triangle,
                                     double& growth);

/// Whether body and triangle have a point in common.
template <class Body> bool reaches(const Body& body, const Triangle& triangle) {
  double growth;
  find_growing_contact(body, triangle, growth);
  return growth < 1.0;
}

/// Lower bound of the distance between body and triangle (length): that along the way from the
/// body's centre to the nearest point of the triangle.
double smallest_gap(const EllipsoidBody& body, const Triangle& triangle);
double smallest_gap(const MultispherePose& pose, const Triangle& triangle);

/// Largest distance of the body's points from its own centre (length).
double extent(const EllipsoidBody& body);
inline double extent(const SphereBody& body) { return body.radius; }

/// Nearest point of the triangle to `point` (Ericson, Real-Time Collision Detection, 5.1.5).
Vector3 nearest_point(const Triangle& triangle, const Vector3& point);

/// Weights of the corners whose sum is a point of the triangle's plane.
Vector3 barycentric(const Triangle& triangle, const Vector3& point);

/// Unit normal; the direction follows the right hand and the order of the corners.
Vector3 unit_normal(const Triangle& triangle);

/// Whether the segment between the points crosses the triangle, ends not counted: the crossing must
/// lie between the shares `first` and `last` of the segment.
bool crosses(const Triangle& triangle, const Vector3& from, const Vector3& to, double first,
             double last);

} // namespace ellipsoid
