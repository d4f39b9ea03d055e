// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "space_overlays.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace ellipsoid::post {
namespace {

constexpr Colour ink{0.13, 0.15, 0.18}, grey{0.45, 0.47, 0.50};

Style line_style(const Colour& colour, double width) {
  Style line;
  line.line = colour;
  line.line_width = width;
  return line;
}

/// The rectangle of a plane within the shown part; empty where the plane is far away.
std::vector<Vector3> rectangle_of(const PrimitivePlane& plane, const Box& shown) {
  constexpr double near = 0.25; // of the shown length
  const double length = shown.upper[plane.axis] - shown.lower[plane.axis];
  if (plane.place < shown.lower[plane.axis] - near * length ||
      plane.place > shown.upper[plane.axis] + near * length)
    return {};
  std::vector<Vector3> corners;
  const unsigned u = (plane.axis + 1) % 3, v = (plane.axis + 2) % 3;
  for (const auto& [at_u, at_v] : {std::pair(false, false), std::pair(true, false),
                                   std::pair(true, true), std::pair(false, true)}) {
    double corner[3];
    corner[plane.axis] = plane.place;
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

} // namespace

void draw_axes(Canvas& canvas, const SpaceView& view, const PixelPoint& corner, double unit) {
  const Camera camera(view);
  const Vector3 axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return camera.seen(axes[i]).z < camera.seen(axes[j]).z;
  });
  const Style line = line_style(ink, 2.5 * unit);
  TextStyle text;
  text.size = 22.0 * unit;
  text.anchor = Anchor::middle;
  for (const std::size_t k : order) {
    const Vector3 tip = camera.seen(axes[k]);
    const double length = 60.0 * unit;
    canvas.line(corner, {corner.x + length * tip.x, corner.y - length * tip.y}, line);
    canvas.text({corner.x + 1.25 * length * tip.x, corner.y - 1.25 * length * tip.y + 8.0 * unit},
                view.axis_names[k], text);
  }
}

void draw_box(Canvas& canvas, const SpaceProjection& to, const Box& box, double unit) {
  const Vector3 corner{box.lower[0], box.lower[1], box.lower[2]};
  std::vector<Vector3> edges = box.tilted_edges;
  if (edges.empty())
    edges = {{box.upper[0] - box.lower[0], 0.0, 0.0},
             {0.0, box.upper[1] - box.lower[1], 0.0},
             {0.0, 0.0, box.upper[2] - box.lower[2]}};
  const Style line = line_style(grey, 1.5 * unit);
  for (std::size_t k = 0; k < 3; ++k)
    for (const double s : {0.0, 1.0})
      for (const double t : {0.0, 1.0}) {
        const Vector3 begin = corner + s * edges[(k + 1) % 3] + t * edges[(k + 2) % 3];
        canvas.line(to.at(begin), to.at(begin + edges[k]), line);
      }
}

void draw_surfaces(Canvas& canvas, const SpaceProjection& to, const SpaceView& view,
                   const Box& shown, double unit) {
  Style pale = line_style(grey, 2.0 * unit);
  pale.is_filled = true;
  pale.fill = grey;
  pale.fill_opacity = 0.15;
  for (const PrimitivePlane& plane : view.planes) {
    std::vector<PixelPoint> corners;
    for (const Vector3& corner : rectangle_of(plane, shown))
      corners.push_back(to.at(corner));
    if (!corners.empty())
      canvas.polyline(corners, true, pale);
  }
  const Style line = line_style({0.30, 0.42, 0.55}, 1.5 * unit);
  for (const auto& [begin, end] : edges_of(view.triangles, Camera(view).towards))
    canvas.line(to.at(vector_of(begin)), to.at(vector_of(end)), line);
}

} // namespace ellipsoid::post
