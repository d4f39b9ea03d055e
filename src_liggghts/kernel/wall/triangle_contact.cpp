// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall/triangle_contact.h"

#include "wall/wall_tolerances.h"

#include <algorithm>

namespace ellipsoid {

namespace {

/// A plane so little out of reach (share of the squared distance) is left to find_plane_contact().
constexpr double plane_rounding = 1e-14;

Vector3 area_vector(const Triangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// Whether a point of the triangle's plane lies on it, or outside by at most `margin` (length).
bool is_on(const Triangle& t, const Vector3& normal, const Vector3& point, double margin) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 edge = t[(k + 1) % 3] - t[k];
    if (dot(cross(normal, edge), point - t[k]) < -margin * norm(edge))
      return false;
  }
  return true;
}

Vector3 divided(const Vector3& a, const Vector3& b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
Vector3 multiplied(const Vector3& a, const Vector3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// Contact along a given normal at a point of the triangle.
TriangleContact contact_at(TriangleFeature feature, const EllipsoidBody& body, const Vector3& foot,
                           const Vector3& normal) {
  const ContactGeometry g = find_plane_contact(body.shape, foot, normal);
  TriangleContact c;
  c.feature = feature;
  c.normal = normal;
  c.foot = foot;
  c.overlap = g.overlap;
  c.point = foot + (0.5 * g.overlap) * normal;
  c.deep = g.overlap > body.shape.smallest_curvature_radius;
  c.reduced_radius = g.curvature_radius_i;
  return c;
}

TriangleContact contact_at(TriangleFeature feature, const SphereBody& body, const Vector3& foot,
                           const Vector3& normal) {
  TriangleContact c;
  c.feature = feature;
  c.sphere = body.number;
  c.normal = normal;
  c.foot = foot;
  c.overlap = body.radius + dot(normal, body.centre) - dot(normal, foot);
  c.point = foot + (0.5 * c.overlap) * normal;
  c.deep = c.overlap > body.radius;
  c.reduced_radius = body.radius;
  return c;
}

/// Collects what edges and corners offer.
class Boundary {
 public:
  Boundary(const EllipsoidBody& body, const Triangle& triangle)
      : body_(body), triangle_(triangle) {}

  TriangleContact best() const {
    return minimum_.feature != TriangleFeature::none ? minimum_ : deepest_;
  }

  void add_corner(std::size_t k) {
    if (is_inside(triangle_[k]))
      add(contact_at(
          TriangleFeature::corner, body_, triangle_[k],
          body_.axes.to_space(nearest_normal(body_.semiaxes, body_.axes.to_body(triangle_[k])))));
  }

  /// The edge from corner k on, ends not counted.
  void add_edge(std::size_t k) {
    const Vector3 start = triangle_[k], way = triangle_[(k + 1) % 3] - start;
    const double length = norm(way);
    const Vector3 direction = (1.0 / length) * way;
    const Shadow shadow = shadow_along(body_.shape, direction);
    const double x = dot(shadow.major, start) / shadow.a, y = dot(shadow.minor, start) / shadow.b;
    if (!(x * x + y * y < 1.0))
      return; // the edge's line passes by
    const Vector3 normal = nearest_normal(shadow, start);
    const Vector3 surface = (1.0 / support(body_.shape, normal)) * (body_.shape.a_matrix * normal);
    const double along = dot(direction, surface - start);
    const Vector3 foot = start + along * direction;
    if (along > 0.0 && along < length && is_inside(foot))
      add(contact_at(TriangleFeature::edge, body_, foot, normal));
  }

 private:
  const EllipsoidBody& body_;
  const Triangle& triangle_;
  TriangleContact minimum_; // the smallest overlap of those with the triangle behind the normal
  TriangleContact deepest_; // if rounding leaves none of these: the largest overlap of all

  bool is_inside(const Vector3& point) const {
    const Vector3 scaled = divided(body_.axes.to_body(point), body_.semiaxes);
    return dot(scaled, scaled) < 1.0;
  }

  void add(const TriangleContact& c) {
    const bool behind = std::all_of(triangle_.begin(), triangle_.end(), [&](const Vector3& node) {
      const Vector3 way = node - c.foot;
      return dot(c.normal, way) >= -wall_tolerance::behind_plane * norm(way);
    });
    if (behind && (minimum_.feature == TriangleFeature::none || c.overlap < minimum_.overlap))
      minimum_ = c;
    if (deepest_.feature == TriangleFeature::none || c.overlap > deepest_.overlap)
      deepest_ = c;
  }
};

} // namespace

TriangleContacts find_face_contact(const EllipsoidBody& body, const Triangle& t) {
  TriangleContacts contacts;
  const Vector3 area = area_vector(t);
  const double height = dot(area, t[0]); // times |area|
  if (height * height > (1.0 + plane_rounding) * dot(area, body.shape.a_matrix * area))
    return contacts;
  const Vector3 right = normalized(area);
  const Vector3 normal = dot(right, t[0]) < 0.0 ? -right : right;
  const ContactGeometry plane = find_plane_contact(body.shape, t[0], normal);
  if (plane.status == ContactStatus::separated)
    return contacts;
  contacts.plane_is_reached = contacts.boundary_may_touch = true;
  const Vector3 foot = plane.point - (0.5 * plane.overlap) * normal;
  if (!is_on(t, right, foot, wall_tolerance::on_triangle * extent(body)))
    return contacts;
  contacts.face = contact_at(TriangleFeature::face, body, foot, normal);
  contacts.face.point = plane.point;
  contacts.face.overlap = plane.overlap;
  // a shallow one is the only minimum (Blaschke; see is_settled in ellipsoid_contact.h)
  contacts.boundary_may_touch = contacts.face.deep;
  if (contacts.face.deep)
    contacts.face_is_missed = !reaches(body, t);
  return contacts;
}

TriangleContact find_boundary_contact(const EllipsoidBody& body, const Triangle& t) {
  Boundary boundary(body, t);
  for (std::size_t k = 0; k < 3; ++k) {
    boundary.add_edge(k);
    boundary.add_corner(k);
  }
  return boundary.best();
}

TriangleContacts find_face_contact(const SphereBody& body, const Triangle& t) {
  TriangleContacts contacts;
  const Vector3 area = area_vector(t);
  const double raised = dot(area, body.centre - t[0]); // height times |area|
  const bool above = body.beyond_wall ? dot(area, t[0]) < 0.0 : raised > 0.0;
  if (above == (raised > 0.0) && // most triangles are out of reach: no root for these
      raised * raised > (1.0 + plane_rounding) * body.radius * body.radius * dot(area, area))
    return contacts;
  const Vector3 right = normalized(area);
  const double height = dot(right, body.centre - t[0]);
  if ((above ? height : -height) > body.radius)
    return contacts;
  contacts.plane_is_reached = true;
  const Vector3 foot = body.centre - height * right;
  contacts.boundary_may_touch = !is_on(t, right, foot, wall_tolerance::on_triangle * extent(body));
  if (!contacts.boundary_may_touch)
    contacts.face = contact_at(TriangleFeature::face, body, foot, above ? -right : right);
  return contacts;
}

TriangleContact find_boundary_contact(const SphereBody& body, const Triangle& t) {
  const Vector3 near = nearest_point(t, body.centre), way = near - body.centre;
  const double distance = norm(way);
  if (!(distance < body.radius && distance > 0.0))
    return {};
  const bool corner = std::any_of(t.begin(), t.end(), [&](const Vector3& node) {
    return norm(near - node) <= wall_tolerance::on_triangle * body.radius;
  });
  return contact_at(corner ? TriangleFeature::corner : TriangleFeature::edge, body, near,
                    (1.0 / distance) * way);
}

double smallest_gap(const EllipsoidBody& body, const Triangle& t) {
  const Vector3 near = nearest_point(t, {});
  const double distance = norm(near);
  return distance > 0.0 ? distance - support(body.shape, near) / distance : 0.0;
}

double smallest_gap(const MultispherePose& pose, const Triangle& t) {
  const Vector3 near = nearest_point(t, {});
  const double distance = norm(near);
  if (!(distance > 0.0))
    return 0.0;
  return distance - largest_reach(pose, (1.0 / distance) * near);
}

TriangleContact find_growing_contact(const EllipsoidBody& body, const Triangle& t, double& growth) {
  Triangle scaled; // in these coordinates the body is the unit sphere
  for (std::size_t k = 0; k < 3; ++k)
    scaled[k] = divided(body.axes.to_body(t[k]), body.semiaxes);
  const Vector3 near = nearest_point(scaled, {});
  growth = norm(near);
  const Vector3 normal =
      growth > 0.0 ? normalized(body.axes.to_space(divided(near, body.semiaxes))) : unit_normal(t);
  return contact_at(TriangleFeature::face, body,
                    body.axes.to_space(multiplied(near, body.semiaxes)), normal);
}

TriangleContact find_growing_contact(const SphereBody& body, const Triangle& t, double& growth) {
  const Vector3 near = nearest_point(t, body.centre), way = near - body.centre;
  const double distance = norm(way);
  growth = distance / body.radius;
  return contact_at(TriangleFeature::face, body, near,
                    distance > 0.0 ? (1.0 / distance) * way : unit_normal(t));
}

double extent(const EllipsoidBody& body) {
  return std::max({body.semiaxes.x, body.semiaxes.y, body.semiaxes.z});
}

Vector3 unit_normal(const Triangle& t) { return normalized(area_vector(t)); }

Vector3 nearest_point(const Triangle& t, const Vector3& p) {
  const Vector3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0)
    return t[0];
  const Vector3 bp = p - t[1];
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3)
    return t[1];
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
    return t[0] + (d1 / (d1 - d3)) * ab;
  const Vector3 cp = p - t[2];
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6)
    return t[2];
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
    return t[0] + (d2 / (d2 - d6)) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6)
    return t[1] + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (t[2] - t[1]);
  const double scale = 1.0 / (va + vb + vc);
  return t[0] + (scale * vb) * ab + (scale * vc) * ac;
}

Vector3 barycentric(const Triangle& t, const Vector3& p) {
  const Vector3 area = area_vector(t);
  const double scale = 1.0 / dot(area, area);
  return {scale * dot(area, cross(t[2] - t[1], p - t[1])),
          scale * dot(area, cross(t[0] - t[2], p - t[2])),
          scale * dot(area, cross(t[1] - t[0], p - t[0]))};
}

bool crosses(const Triangle& t, const Vector3& from, const Vector3& to, double first, double last) {
  const Vector3 area = area_vector(t);
  const double before = dot(area, from - t[0]), after = dot(area, to - t[0]);
  if ((before > 0.0) == (after > 0.0))
    return false;
  const double share = before / (before - after);
  if (!(share > first && share < last))
    return false;
  const Vector3 point = from + share * (to - from);
  return is_on(t, normalized(area), point, wall_tolerance::on_triangle * norm(to - from));
}

} // namespace ellipsoid
