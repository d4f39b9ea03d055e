// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "nested_surfaces.h"

#include "disjoint_sets.h"
#include "input_error.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <tuple>
#include <utility>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;
constexpr std::size_t most_corners = 24; ///< of a surface that are looked for in another one

using Surface = std::vector<Triangle3>;
using Corner = std::tuple<double, double, double>;

Corner corner_of(const Vector3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; } // -0 is 0

/// Triangles that hang together by edges.
std::vector<Surface> connected_surfaces(const Surface& triangles) {
  DisjointSets sets(triangles.size());
  std::map<std::pair<Corner, Corner>, std::size_t> owners;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner from = corner_of(triangles[i][k]), to = corner_of(triangles[i][(k + 1) % 3]);
      const auto [owner, is_new] = owners.emplace(std::minmax(from, to), i);
      if (!is_new)
        sets.join(owner->second, i);
    }
  std::map<std::size_t, Surface> by_root;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    by_root[sets.root(i)].push_back(triangles[i]);
  std::vector<Surface> surfaces;
  for (auto& [root, surface] : by_root)
    surfaces.push_back(std::move(surface));
  return surfaces;
}

/// By the solid angle under which the surface is seen (van Oosterom, Strackee 1983).
bool holds(const Surface& surface, const Vector3& point) {
  double angle = 0.0;
  for (const Triangle3& t : surface) {
    const Vector3 a = t[0] - point, b = t[1] - point, c = t[2] - point;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    angle += 2.0 * std::atan2(dot(a, cross(b, c)),
                              la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return std::fabs(angle) > 2.0 * pi;
}

bool holds(const Surface& outer, const Surface& inner, const std::string& name) {
  const std::size_t stride = std::max<std::size_t>(1, inner.size() / most_corners);
  std::size_t inside = 0, looked_at = 0;
  for (std::size_t i = 0; i < inner.size(); i += stride, ++looked_at)
    inside += holds(outer, inner[i][0]) ? 1 : 0;
  if (inside > 0 && inside < looked_at)
    throw InputError(name + ": two closed surfaces in it cut each other; unite them to one");
  return inside > 0;
}

double volume_of(const Surface& surface) {
  const Vector3 origin = surface.front()[0];
  double volume = 0.0;
  for (const Triangle3& t : surface)
    volume += dot(t[0] - origin, cross(t[1] - origin, t[2] - origin)) / 6.0;
  return volume;
}

} // namespace

std::vector<Triangle3> surface_of_one_body(const std::vector<Triangle3>& triangles,
                                           const std::string& name) {
  const std::vector<Surface> surfaces = connected_surfaces(triangles);
  if (surfaces.size() == 1)
    return triangles;
  Surface body;
  std::size_t bodies = 0;
  for (const Surface& surface : surfaces) {
    std::size_t depth = 0;
    for (const Surface& other : surfaces)
      depth += &other != &surface && holds(other, surface, name) ? 1 : 0;
    bodies += depth % 2 == 0 ? 1 : 0;
    const bool is_turned = (volume_of(surface) < 0.0) == (depth % 2 == 0);
    for (const Triangle3& t : surface)
      body.push_back(is_turned ? Triangle3{t[0], t[2], t[1]} : t);
  }
  if (bodies > 1)
    throw InputError(fmt::format("{}: {} bodies apart in {} closed surfaces; a clump is one body: "
                                 "give a file with one of them",
                                 name, bodies, surfaces.size()));
  return body;
}

} // namespace ellipsoid::post
