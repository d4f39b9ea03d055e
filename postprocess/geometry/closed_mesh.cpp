// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "closed_mesh.h"

#include "input_error.h"
#include "nested_surfaces.h"
#include "solid_columns.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace ellipsoid::post {
namespace {

using Corner = std::tuple<double, double, double>;

Corner corner_of(const Vector3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; } // -0 is 0

Vector3 area_vector(const Triangle3& t) { return 0.5 * cross(t[1] - t[0], t[2] - t[0]); }

/// How often an edge, from its smaller to its larger corner, is passed to and fro.
struct Passes {
  int forward = 0, backward = 0;
};

void check_edges(const std::vector<Triangle3>& triangles, const std::string& name) {
  std::map<std::pair<Corner, Corner>, Passes> edges;
  for (const Triangle3& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner from = corner_of(t[k]), to = corner_of(t[(k + 1) % 3]);
      if (from < to)
        ++edges[{from, to}].forward;
      else
        ++edges[{to, from}].backward;
    }
  const auto bad = [](const auto& edge) {
    return edge.second.forward != 1 || edge.second.backward != 1;
  };
  const auto first = std::find_if(edges.begin(), edges.end(), bad);
  if (first == edges.end())
    return;
  const auto& [x, y, z] = first->first.first;
  throw InputError(fmt::format(
      "{}: the surface is not closed: {} of {} edges do not belong to just two triangles turned "
      "the same way, one of them at ({:g}, {:g}, {:g}); mend the mesh (fill holes, join equal "
      "corners)",
      name, std::count_if(edges.begin(), edges.end(), bad), edges.size(), x, y, z));
}

constexpr int test_columns = 300;       ///< over each side of the box
constexpr double most_entangled = 1e-3; ///< of the volume; less does not change what is measured

/// A scan may have folds that cut each other: they do no harm where they are small.
void check_entangled(const std::vector<Triangle3>& triangles, const MeshMeasures& m,
                     const std::string& name) {
  const Vector3 size = m.box.upper - m.box.lower;
  const ColumnGrid grid{m.box.lower.x,         m.box.lower.y, size.x / test_columns,
                        size.y / test_columns, test_columns,  test_columns};
  const double share = entangled_volume(grid, triangles) / std::fabs(m.volume);
  if (share > most_entangled)
    throw InputError(fmt::format(
        "{}: the surface cuts itself: {:.3g} % of its volume lies where it goes round twice or the "
        "wrong way, {:g} % are allowed; mend the mesh (unite what overlaps)",
        name, 100.0 * share, 100.0 * most_entangled));
}

SymmetricMatrix3 square_of(const Vector3& a) {
  return {a.x * a.x, a.y * a.y, a.z * a.z, a.x * a.y, a.x * a.z, a.y * a.z};
}

Vector3 nearest_on_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 along = b - a;
  return a + std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0) * along;
}

Vector3 nearest_on_triangle(const Vector3& p, const Triangle3& t) {
  const Vector3 normal = area_vector(t);
  bool is_above = true;
  for (std::size_t k = 0; k < 3; ++k)
    is_above = is_above && dot(cross(t[(k + 1) % 3] - t[k], p - t[k]), normal) >= 0.0;
  if (is_above)
    return p - (dot(p - t[0], normal) / dot(normal, normal)) * normal;
  Vector3 best = t[0];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 q = nearest_on_segment(p, t[k], t[(k + 1) % 3]);
    if (norm(q - p) < norm(best - p))
      best = q;
  }
  return best;
}

void widen(Vector3& lower, Vector3& upper, const Vector3& p) {
  lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
  upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
}

double squared_distance(const Vector3& p, const Vector3& lower, const Vector3& upper) {
  const Vector3 apart{std::max({lower.x - p.x, 0.0, p.x - upper.x}),
                      std::max({lower.y - p.y, 0.0, p.y - upper.y}),
                      std::max({lower.z - p.z, 0.0, p.z - upper.z})};
  return dot(apart, apart);
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t leaf_size = 6;

} // namespace

std::vector<Triangle3> checked_closed(std::vector<Triangle3> triangles, const std::string& name) {
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [](const Triangle3& t) {
                                   const Corner a = corner_of(t[0]), b = corner_of(t[1]),
                                                c = corner_of(t[2]);
                                   return a == b || b == c || c == a;
                                 }),
                  triangles.end());
  if (triangles.empty())
    throw InputError(name + ": no triangles; a closed surface is needed");
  check_edges(triangles, name);
  triangles = surface_of_one_body(triangles, name);
  const MeshMeasures m = measure_mesh(triangles);
  const Vector3 size = m.box.upper - m.box.lower;
  if (!(std::fabs(m.volume) > 1e-9 * norm(size) * norm(size) * norm(size)))
    throw InputError(name +
                     ": the surface encloses no volume; a closed surface of a body is needed");
  if (m.volume < 0.0)
    for (Triangle3& t : triangles)
      std::swap(t[1], t[2]);
  check_entangled(triangles, m, name);
  return triangles;
}

/// Sums over the tetrahedra that the triangles form with the middle of the box.
MeshMeasures measure_mesh(const std::vector<Triangle3>& triangles) {
  MeshMeasures m;
  m.box = {triangles.front()[0], triangles.front()[0]};
  for (const Triangle3& t : triangles)
    for (const Vector3& p : t)
      widen(m.box.lower, m.box.upper, p);
  const Vector3 origin = 0.5 * (m.box.lower + m.box.upper);
  Vector3 first;
  SymmetricMatrix3 second;
  for (const Triangle3& t : triangles) {
    const Vector3 a = t[0] - origin, b = t[1] - origin, c = t[2] - origin, sum = a + b + c;
    const double volume = dot(a, cross(b, c)) / 6.0;
    m.surface += norm(area_vector(t));
    m.volume += volume;
    first += 0.25 * volume * sum;
    second = second + 0.05 * volume * (square_of(a) + square_of(b) + square_of(c) + square_of(sum));
  }
  const Vector3 centre = (1.0 / m.volume) * first;
  const SymmetricMatrix3 about = second + -m.volume * square_of(centre);
  const double trace = about.xx + about.yy + about.zz;
  m.centre = origin + centre;
  m.inertia = SymmetricMatrix3{trace, trace, trace, 0.0, 0.0, 0.0} + -1.0 * about;
  return m;
}

std::vector<MeshPoint> mesh_points(const std::vector<Triangle3>& triangles, int count) {
  std::vector<double> reached; // area up to each triangle's end
  double area = 0.0;
  for (const Triangle3& t : triangles)
    reached.push_back(area += norm(area_vector(t)));
  std::vector<MeshPoint> points;
  for (int i = 0; i < count; ++i) {
    const auto at = std::lower_bound(reached.begin(), reached.end(), area * (i + 0.5) / count);
    const Triangle3& t =
        triangles[std::min(triangles.size() - 1, static_cast<std::size_t>(at - reached.begin()))];
    double u = 0.7548776662466927 * (i + 1), v = 0.5698402909980532 * (i + 1); // a plane lattice
    u -= std::floor(u);
    v -= std::floor(v);
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const Vector3 normal = area_vector(t);
    if (norm(normal) > 0.0)
      points.push_back({t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]), normalized(normal)});
  }
  return points;
}

TriangleTree::TriangleTree(std::vector<Triangle3> triangles) : triangles_(std::move(triangles)) {
  build(0, triangles_.size());
}

void TriangleTree::build(std::size_t begin, std::size_t end) {
  Node node{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}, begin, end, 0};
  for (std::size_t k = begin; k < end; ++k)
    for (const Vector3& p : triangles_[k])
      widen(node.lower, node.upper, p);
  const std::size_t index = nodes_.size();
  nodes_.push_back(node);
  if (end - begin <= leaf_size)
    return;
  const Vector3 size = node.upper - node.lower;
  const auto middle_of = [&](const Triangle3& t) {
    const Vector3 sum = t[0] + t[1] + t[2];
    return size.x >= size.y && size.x >= size.z ? sum.x : size.y >= size.z ? sum.y : sum.z;
  };
  const auto from = triangles_.begin() + static_cast<std::ptrdiff_t>(begin);
  const std::size_t half = (end - begin) / 2;
  std::nth_element(
      from, from + static_cast<std::ptrdiff_t>(half),
      triangles_.begin() + static_cast<std::ptrdiff_t>(end),
      [&](const Triangle3& s, const Triangle3& t) { return middle_of(s) < middle_of(t); });
  build(begin, begin + half);
  nodes_[index].right = nodes_.size();
  build(begin + half, end);
}

void TriangleTree::search(std::size_t index, const Vector3& point, double& square,
                          Vector3& nearest) const {
  const Node& node = nodes_[index];
  if (node.right == 0) {
    for (std::size_t k = node.begin; k < node.end; ++k) {
      const Vector3 q = nearest_on_triangle(point, triangles_[k]);
      const double found = dot(q - point, q - point);
      if (found < square) {
        square = found;
        nearest = q;
      }
    }
    return;
  }
  const Node &left = nodes_[index + 1], &right = nodes_[node.right];
  const double to_left = squared_distance(point, left.lower, left.upper),
               to_right = squared_distance(point, right.lower, right.upper);
  const bool left_first = to_left <= to_right;
  if ((left_first ? to_left : to_right) < square)
    search(left_first ? index + 1 : node.right, point, square, nearest);
  if ((left_first ? to_right : to_left) < square)
    search(left_first ? node.right : index + 1, point, square, nearest);
}

Vector3 TriangleTree::nearest(const Vector3& point) const {
  double square = infinity;
  Vector3 found;
  search(0, point, square, found);
  return found;
}

} // namespace ellipsoid::post
