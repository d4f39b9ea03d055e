// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "space_scenery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace ellipsoid::post {
namespace {

/// The rectangle of a plane within the shown part; empty where the plane is far away.
std::vector<Vector3> rectangle_of(const PrimitivePlane& plane, const Box& shown) {
  constexpr double near = 0.25; // of the shown length
  const double length = shown.upper[plane.axis] - shown.lower[plane.axis];
  if (plane.position < shown.lower[plane.axis] - near * length ||
      plane.position > shown.upper[plane.axis] + near * length)
    return {};
  std::vector<Vector3> corners;
  const unsigned u = (plane.axis + 1) % 3, v = (plane.axis + 2) % 3;
  for (const auto& [at_u, at_v] : {std::pair(false, false), std::pair(true, false),
                                   std::pair(true, true), std::pair(false, true)}) {
    double corner[3];
    corner[plane.axis] = plane.position;
    corner[u] = at_u ? shown.upper[u] : shown.lower[u];
    corner[v] = at_v ? shown.upper[v] : shown.lower[v];
    corners.push_back({corner[0], corner[1], corner[2]});
  }
  return corners;
}

using Corner = std::array<double, 3>;
using Edge = std::pair<Corner, Corner>;

Corner key_of(const Vector3& v) { return {v.x, v.y, v.z}; }
Vector3 vector_of(const Corner& c) { return {c[0], c[1], c[2]}; }

/// Whether an edge between two triangles shows the form of a mesh: a fold, or where the surface
/// turns away from the camera.
bool is_shown(const Vector3& one, Vector3 other, const Vector3& towards) {
  constexpr double flat = 0.9397; // cosine of 20 degrees
  if (dot(one, other) < 0.0)      // whatever the order of the corners
    other = -other;
  return dot(one, other) < flat || dot(one, towards) * dot(other, towards) < 0.0;
}

/// @param[in] towards the camera
std::vector<Edge> edges_of(const std::vector<std::array<Vector3, 3>>& triangles,
                           const Vector3& towards) {
  std::map<Edge, std::vector<Vector3>> normals_at;
  for (const auto& t : triangles) {
    const Vector3 normal = cross(t[1] - t[0], t[2] - t[0]);
    if (!(norm(normal) > 0.0))
      continue;
    for (std::size_t k = 0; k < 3; ++k)
      normals_at[std::minmax(key_of(t[k]), key_of(t[(k + 1) % 3]))].push_back(normalized(normal));
  }
  std::vector<Edge> edges;
  for (const auto& [edge, normals] : normals_at)
    if (normals.size() != 2 || is_shown(normals[0], normals[1], towards))
      edges.push_back(edge);
  return edges;
}

void append_outline(std::vector<SpaceLine>& lines, const std::vector<Vector3>& corners) {
  for (std::size_t k = 0; k < corners.size(); ++k)
    lines.push_back({corners[k], corners[(k + 1) % corners.size()], LineKind::wall});
}

/// The twelve edges of a box, also of a tilted one.
void append_box(std::vector<SpaceLine>& lines, const Box& box) {
  const Vector3 corner{box.lower[0], box.lower[1], box.lower[2]};
  std::vector<Vector3> edges = box.tilted_edges;
  if (edges.empty())
    edges = {{box.upper[0] - box.lower[0], 0.0, 0.0},
             {0.0, box.upper[1] - box.lower[1], 0.0},
             {0.0, 0.0, box.upper[2] - box.lower[2]}};
  for (std::size_t k = 0; k < 3; ++k)
    for (const double s : {0.0, 1.0})
      for (const double t : {0.0, 1.0}) {
        const Vector3 begin = corner + s * edges[(k + 1) % 3] + t * edges[(k + 2) % 3];
        lines.push_back({begin, begin + edges[k], LineKind::box});
      }
}

/// Rays from the first to one behind the last that an interval may touch.
struct RayRange {
  std::size_t begin = 0, end = 0;
};

RayRange rays_over(double low, double high, std::size_t count) {
  const auto clamped = [count](double k) {
    return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(count)));
  };
  return {clamped(std::floor(low)), clamped(std::ceil(high) + 1.0)};
}

RayRange columns_over(const DepthBuffer& buffer, const Screen& screen, double x0, double x1) {
  return rays_over((x0 - screen.left) * screen.scale, (x1 - screen.left) * screen.scale,
                   buffer.width);
}

RayRange rows_over(const DepthBuffer& buffer, const Screen& screen, double y0, double y1) {
  return rays_over((screen.top - y1) * screen.scale, (screen.top - y0) * screen.scale,
                   buffer.height);
}

/// A convex polygon in the camera's frame: its depth at (x, y), where it covers that place.
struct SeenPolygon {
  std::vector<Vector3> corners;
  Vector3 normal; ///< not of length 1

  bool covers(double x, double y, double& z) const {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vector3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
      const double side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
      if (side * normal.z < 0.0)
        return false;
    }
    const Vector3& a = corners.front();
    z = a.z - (normal.x * (x - a.x) + normal.y * (y - a.y)) / normal.z;
    return true;
  }
};

void draw_wall(DepthBuffer& buffer, const Screen& screen, const std::vector<Vector3>& wall,
               const Camera& camera) {
  SeenPolygon seen;
  for (const Vector3& corner : wall)
    seen.corners.push_back(camera.seen(corner));
  const auto& c = seen.corners;
  seen.normal = cross(c[1] - c[0], c[2] - c[0]);
  constexpr double edge_on = 1e-6; // cosine
  if (std::abs(seen.normal.z) <= edge_on * norm(seen.normal))
    return; // its outline is a line
  const auto by_x = [](const Vector3& p, const Vector3& q) { return p.x < q.x; };
  const auto by_y = [](const Vector3& p, const Vector3& q) { return p.y < q.y; };
  const auto [left, right] = std::minmax_element(c.begin(), c.end(), by_x);
  const auto [low, high] = std::minmax_element(c.begin(), c.end(), by_y);
  const RayRange columns = columns_over(buffer, screen, left->x, right->x);
  const RayRange rows = rows_over(buffer, screen, low->y, high->y);
  for (std::size_t j = rows.begin; j < rows.end; ++j)
    for (std::size_t i = columns.begin; i < columns.end; ++i) {
      double z = 0.0;
      const std::size_t ray = j * buffer.width + i;
      if (seen.covers(screen.x(i), screen.y(j), z) && z > buffer.depth[ray] &&
          buffer.walls[ray] < 255)
        ++buffer.walls[ray];
    }
}

/// A line in the camera's frame, as wide as twice its reach.
struct SeenLine {
  Vector3 begin, way;
  double reach; ///< (length)

  /// Abscissae of the line between two ordinates.
  std::pair<double, double> abscissae(double y0, double y1) const {
    double from = 0.0, to = 1.0;
    if (way.y != 0.0) {
      const auto [s, t] = std::minmax({(y0 - begin.y) / way.y, (y1 - begin.y) / way.y}); // values
      from = std::clamp(s, 0.0, 1.0);
      to = std::clamp(t, 0.0, 1.0);
    }
    const double x0 = begin.x + from * way.x, x1 = begin.x + to * way.x;
    return {std::min(x0, x1), std::max(x0, x1)};
  }

  /// Whether the line covers (x, y), and its depth there.
  bool covers(double x, double y, double& z) const {
    const double square = way.x * way.x + way.y * way.y;
    const double along = (x - begin.x) * way.x + (y - begin.y) * way.y;
    const double t = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
    z = begin.z + t * way.z;
    return std::hypot(x - begin.x - t * way.x, y - begin.y - t * way.y) <= reach;
  }
};

void draw_line(DepthBuffer& buffer, const Screen& screen, const SeenLine& line, LineKind kind) {
  const double y0 = std::min(line.begin.y, line.begin.y + line.way.y) - line.reach;
  const double y1 = std::max(line.begin.y, line.begin.y + line.way.y) + line.reach;
  const RayRange rows = rows_over(buffer, screen, y0, y1);
  for (std::size_t j = rows.begin; j < rows.end; ++j) {
    const double y = screen.y(j);
    const auto [x0, x1] = line.abscissae(y - line.reach, y + line.reach);
    const RayRange columns = columns_over(buffer, screen, x0 - line.reach, x1 + line.reach);
    for (std::size_t i = columns.begin; i < columns.end; ++i) {
      double z = 0.0;
      const std::size_t ray = j * buffer.width + i;
      if (line.covers(screen.x(i), y, z) && z + line.reach > buffer.depth[ray])
        buffer.lines[ray] = kind;
    }
  }
}

} // namespace

const Colour* colour_of(LineKind kind) {
  static const Colour mesh{0.30, 0.42, 0.55};
  if (kind == LineKind::none)
    return nullptr;
  return kind == LineKind::mesh ? &mesh : &wall_colour;
}

SpaceScenery scenery_of(const SpaceView& view, const Box& box, const Box& shown, double unit) {
  SpaceScenery scenery;
  scenery.line_width = 1.7 * unit;
  for (const PrimitivePlane& plane : view.planes)
    if (const std::vector<Vector3> corners = rectangle_of(plane, shown); !corners.empty()) {
      scenery.walls.push_back(corners);
      append_outline(scenery.lines, corners);
    }
  for (const auto& [begin, end] : edges_of(view.triangles, Camera(view).towards))
    scenery.lines.push_back({vector_of(begin), vector_of(end), LineKind::mesh});
  if (view.show_box)
    append_box(scenery.lines, box);
  return scenery;
}

void draw_scenery(DepthBuffer& buffer, const Screen& screen, const SpaceScenery& scenery,
                  const Camera& camera) {
  for (const std::vector<Vector3>& wall : scenery.walls)
    draw_wall(buffer, screen, wall, camera);
  const double reach = 0.5 * std::max(1.0, scenery.line_width) * rays_per_side / screen.scale;
  for (const SpaceLine& line : scenery.lines) {
    const Vector3 begin = camera.seen(line.begin);
    draw_line(buffer, screen, {begin, camera.seen(line.end) - begin, reach}, line.kind);
  }
}

} // namespace ellipsoid::post
