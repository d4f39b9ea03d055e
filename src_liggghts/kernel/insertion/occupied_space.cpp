// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "insertion/occupied_space.h"

#include <cmath>

namespace ellipsoid {

std::size_t OccupiedSpace::CellHash::operator()(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t k : cell) // FNV-1a, number by number
    hash = (hash ^ static_cast<std::uint64_t>(k)) * 1099511628211u;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

OccupiedSpace::Cell OccupiedSpace::cell_at(const Vector3& point, double length) {
  const auto number = [length](double x) {
    return static_cast<std::int64_t>(std::floor(x / length));
  };
  return {number(point.x), number(point.y), number(point.z)};
}

void OccupiedSpace::add(const SolidBody& body) {
  const int exponent = std::ilogb(body.bounding_radius) + 2; // 2 r <= length < 4 r
  grids_[exponent][cell_at(body.centre, std::ldexp(1.0, exponent))].push_back(
      static_cast<std::uint32_t>(bodies_.size()));
  bodies_.push_back(body);
}

bool OccupiedSpace::is_free(const SolidBody& body) const {
  for (const auto& [exponent, grid] : grids_)
    if (!is_free_in(grid, std::ldexp(1.0, exponent), body))
      return false;
  return true;
}

bool OccupiedSpace::is_free_in(const Grid& grid, double length, const SolidBody& body) const {
  const double reach = body.bounding_radius + 0.5 * length;
  const Vector3 to_corner{reach, reach, reach};
  const Cell low = cell_at(body.centre - to_corner, length),
             high = cell_at(body.centre + to_corner, length);
  double cells = 1.0;
  for (std::size_t k = 0; k < 3; ++k)
    cells *= static_cast<double>(high[k] - low[k] + 1);
  if (cells > static_cast<double>(grid.size())) { // a large body among small ones
    for (const auto& [cell, others] : grid)
      if (!is_free_of(others, body))
        return false;
    return true;
  }
  for (std::int64_t x = low[0]; x <= high[0]; ++x)
    for (std::int64_t y = low[1]; y <= high[1]; ++y)
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const auto found = grid.find({x, y, z});
        if (found != grid.end() && !is_free_of(found->second, body))
          return false;
      }
  return true;
}

bool OccupiedSpace::is_free_of(const std::vector<std::uint32_t>& others,
                               const SolidBody& body) const {
  for (const std::uint32_t other : others)
    if (overlap(body, bodies_[other]))
      return false;
  return true;
}

} // namespace ellipsoid
