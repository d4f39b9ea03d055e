// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "solid_columns.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

std::size_t index_of(const ColumnGrid& grid, int i, int j) {
  return static_cast<std::size_t>(i) +
         static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(j);
}

SolidColumns empty_columns(const ColumnGrid& grid) {
  return SolidColumns(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny));
}

/// Columns whose axes lie from low to high, as a range of indices, the end not included.
std::array<int, 2> range_of(double low, double high, double begin, double width, int count) {
  const double first = std::ceil((low - begin) / width - 0.5),
               behind = std::ceil((high - begin) / width - 0.5);
  return {static_cast<int>(std::clamp(first, 0.0, static_cast<double>(count))),
          static_cast<int>(std::clamp(behind, 0.0, static_cast<double>(count)))};
}

/// Adds a part to disjoint ones in ascending order, joined with those that it overlaps.
void join(ColumnParts& parts, ColumnPart part) {
  const auto first = std::find_if(parts.begin(), parts.end(),
                                  [&](const ColumnPart& p) { return p.to >= part.from; });
  auto last = first;
  for (; last != parts.end() && last->from <= part.to; ++last) {
    part.from = std::min(part.from, last->from);
    part.to = std::max(part.to, last->to);
  }
  if (first == last) {
    parts.insert(first, part);
    return;
  }
  *first = part;
  parts.erase(first + 1, last);
}

/// Where the axis of a column passes a triangle.
struct Crossing {
  double z;
  int step; ///< upwards: 1 into the body, -1 out of it, for triangles that are turned outwards
};

/// The crossings of each column, from below to above.
using Crossings = std::vector<std::vector<Crossing>>;

/// Adds the crossings of the columns with a triangle; one of two triangles with a common edge
/// takes an axis through it.
void add_crossings(const ColumnGrid& grid, const std::array<Vector3, 3>& triangle,
                   Crossings& crossings) {
  const auto [a, b, c] = triangle;
  const auto [i0, i1] = range_of(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), grid.x0,
                                 grid.width_x, grid.nx);
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0.0)
    return;
  for (int i = i0; i < i1; ++i) {
    const double x = grid.x(i);
    std::vector<double> ys; // where the edges pass the plane of this x, each edge half open
    for (std::size_t k = 0; k < 3; ++k) {
      Vector3 p = triangle[k], q = triangle[(k + 1) % 3];
      if ((p.x <= x) == (q.x <= x))
        continue;
      if (q.x < p.x || (q.x == p.x && q.y < p.y)) // the same number for both triangles
        std::swap(p, q);
      ys.push_back(p.y + (q.y - p.y) * ((x - p.x) / (q.x - p.x)));
    }
    if (ys.size() != 2)
      continue;
    const auto [j0, j1] =
        range_of(std::min(ys[0], ys[1]), std::max(ys[0], ys[1]), grid.y0, grid.width_y, grid.ny);
    for (int j = j0; j < j1; ++j) {
      const double y = grid.y(j);
      const double u = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area,
                   v = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
      crossings[index_of(grid, i, j)].push_back(
          {a.z + u * (b.z - a.z) + v * (c.z - a.z), area < 0.0 ? 1 : -1});
    }
  }
}

Crossings sorted_crossings(const ColumnGrid& grid,
                           const std::vector<std::array<Vector3, 3>>& triangles) {
  Crossings crossings(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny));
  for (const std::array<Vector3, 3>& triangle : triangles)
    add_crossings(grid, triangle, crossings);
  for (std::vector<Crossing>& column : crossings)
    std::sort(column.begin(), column.end(),
              [](const Crossing& a, const Crossing& b) { return a.z < b.z; });
  return crossings;
}

} // namespace

ColumnGrid columns_over(const SolidBox& inner, const SolidBox& outer, int along) {
  const Vector3 size = inner.upper - inner.lower;
  const double width = std::max(size.x, size.y) / along;
  ColumnGrid grid;
  grid.width_x = size.x / std::ceil(size.x / width - 1e-9);
  grid.width_y = size.y / std::ceil(size.y / width - 1e-9);
  const double left = std::ceil((inner.lower.x - outer.lower.x) / grid.width_x),
               front = std::ceil((inner.lower.y - outer.lower.y) / grid.width_y);
  grid.x0 = inner.lower.x - left * grid.width_x;
  grid.y0 = inner.lower.y - front * grid.width_y;
  grid.nx = static_cast<int>(std::ceil((outer.upper.x - grid.x0) / grid.width_x - 1e-9));
  grid.ny = static_cast<int>(std::ceil((outer.upper.y - grid.y0) / grid.width_y - 1e-9));
  return grid;
}

SolidColumns ellipsoid_columns(const ColumnGrid& grid, const Vector3& semiaxes) {
  SolidColumns columns = empty_columns(grid);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double u = grid.x(i) / semiaxes.x, v = grid.y(j) / semiaxes.y;
      const double square = 1.0 - u * u - v * v;
      if (square > 0.0)
        columns[index_of(grid, i, j)] = {
            {-semiaxes.z * std::sqrt(square), semiaxes.z * std::sqrt(square)}};
    }
  return columns;
}

SolidColumns sphere_columns(const ColumnGrid& grid, const SphereSet& set) {
  SolidColumns columns = empty_columns(grid);
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    const Vector3& c = set.centres[k];
    const double r = set.radii[k];
    const auto [i0, i1] = range_of(c.x - r, c.x + r, grid.x0, grid.width_x, grid.nx);
    const auto [j0, j1] = range_of(c.y - r, c.y + r, grid.y0, grid.width_y, grid.ny);
    for (int j = j0; j < j1; ++j)
      for (int i = i0; i < i1; ++i) {
        const double u = grid.x(i) - c.x, v = grid.y(j) - c.y;
        const double square = r * r - u * u - v * v;
        if (square > 0.0)
          join(columns[index_of(grid, i, j)], {c.z - std::sqrt(square), c.z + std::sqrt(square)});
      }
  }
  return columns;
}

SolidColumns mesh_columns(const ColumnGrid& grid,
                          const std::vector<std::array<Vector3, 3>>& triangles) {
  SolidColumns columns = empty_columns(grid);
  const Crossings crossings = sorted_crossings(grid, triangles);
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t m = 0; m + 1 < crossings[k].size(); m += 2)
      columns[k].push_back({crossings[k][m].z, crossings[k][m + 1].z});
  return columns;
}

double entangled_volume(const ColumnGrid& grid,
                        const std::vector<std::array<Vector3, 3>>& triangles) {
  double length = 0.0;
  for (const std::vector<Crossing>& column : sorted_crossings(grid, triangles)) {
    int winding = 0;
    for (std::size_t m = 0; m + 1 < column.size(); ++m) {
      winding += column[m].step;
      if (winding != 0 && winding != 1)
        length += column[m + 1].z - column[m].z;
    }
  }
  return grid.width_x * grid.width_y * length;
}

CommonVolume common_volume(const ColumnGrid& grid, const SolidColumns& first,
                           const SolidColumns& second) {
  CommonVolume sum;
  for (std::size_t k = 0; k < first.size(); ++k) {
    for (const ColumnPart& part : second[k])
      sum.second += part.to - part.from;
    for (const ColumnPart& part : first[k]) {
      sum.first += part.to - part.from;
      for (const ColumnPart& other : second[k])
        sum.common += std::max(0.0, std::min(part.to, other.to) - std::max(part.from, other.from));
    }
  }
  const double area = grid.width_x * grid.width_y;
  return {area * sum.first, area * sum.second, area * sum.common};
}

} // namespace ellipsoid::post
