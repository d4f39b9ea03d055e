// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "flow_gate.h"

#include "wall/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ellipsoid::post {
namespace {

struct Point2 {
  double u = 0.0, v = 0.0;
};

double area_of(const Point2& a, const Point2& b, const Point2& p) { ///< twice, left of a -> b: > 0
  return (b.u - a.u) * (p.v - a.v) - (b.v - a.v) * (p.u - a.u);
}

/// Which side of the edge a -> b a point is on, the same number with the other sign for b -> a.
double side_of(const Point2& a, const Point2& b, const Point2& p) {
  const bool is_turned = b.u < a.u || (b.u == a.u && b.v < a.v);
  return is_turned ? -area_of(b, a, p) : area_of(a, b, p);
}

/// Whether a point lies in a triangle with counter-clockwise corners. A point on an edge that two
/// triangles share lies in one of them: the one that passes it downwards, or if level to the left.
bool lies_in(const std::array<Point2, 3>& corners, const Point2& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 &a = corners[k], &b = corners[(k + 1) % 3];
    const double side = side_of(a, b, p);
    const bool has_edge = b.v < a.v || (b.v == a.v && b.u < a.u);
    if (side < 0.0 || (side == 0.0 && !has_edge))
      return false;
  }
  return true;
}

/// Seen along the axis that is nearest to the normal.
bool lies_in(const Triangle& triangle, const Vector3& normal, const Vector3& position) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const auto seen = [&](const Vector3& r) {
    return z >= x && z >= y ? Point2{r.x, r.y} : y >= x ? Point2{r.z, r.x} : Point2{r.y, r.z};
  };
  std::array<Point2, 3> corners{seen(triangle[0]), seen(triangle[1]), seen(triangle[2])};
  if (area_of(corners[0], corners[1], corners[2]) < 0.0)
    std::swap(corners[1], corners[2]);
  return lies_in(corners, seen(position));
}

/// Of a way with a plane, which belongs to its upper side.
std::optional<GateCrossing> plane_crossing(const Vector3& point, const Vector3& normal,
                                           const Vector3& from, const Vector3& to) {
  const double before = dot(from - point, normal), after = dot(to - point, normal);
  if ((before < 0.0) == (after < 0.0))
    return {};
  const double share = before / (before - after);
  return GateCrossing{after < 0.0 ? -1 : 1, share, from + share * (to - from), normal};
}

} // namespace

bool FlowGate::holds(const Vector3& position) const {
  if (!radius)
    return true;
  const Vector3 d = position - point;
  return norm(d - dot(d, normal) * normal) <= *radius;
}

SharesOfEdges shares_of_edges(const FlowGate& gate, const PeriodicCell& cell) {
  SharesOfEdges shares;
  const auto add = [&](const Vector3& place, bool is_first, double reach) {
    const Vector3 f = cell.fractions(place);
    const double share[] = {f.x, f.y, f.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const double off = reach / cell.thickness(k);
      shares.least[k] = is_first ? share[k] - off : std::min(shares.least[k], share[k] - off);
      shares.greatest[k] = is_first ? share[k] + off : std::max(shares.greatest[k], share[k] + off);
    }
  };
  if (gate.triangles.empty())
    add(gate.point, true, gate.radius.value_or(0.0));
  for (const Triangle& triangle : gate.triangles)
    for (const Vector3& corner : triangle)
      add(corner, &corner == &gate.triangles.front()[0], 0.0);
  return shares;
}

std::vector<GateCrossing> crossings(const FlowGate& gate, const Vector3& from, const Vector3& to) {
  std::vector<GateCrossing> found;
  for (const Triangle& triangle : gate.triangles) {
    const Vector3 normal = unit_normal(triangle);
    const auto crossing = plane_crossing(triangle[0], normal, from, to);
    if (crossing && lies_in(triangle, normal, crossing->position))
      found.push_back(*crossing);
  }
  if (!gate.triangles.empty())
    return found;
  const auto crossing = plane_crossing(gate.point, gate.normal, from, to);
  if (crossing && gate.holds(crossing->position))
    found.push_back(*crossing);
  return found;
}

} // namespace ellipsoid::post
