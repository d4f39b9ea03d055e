// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "vector3.h"

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ellipsoid::post {

/// Neighbour search among balls of different sizes: cubic cells of the largest diameter.
class CellGrid {
 public:
  /// @param[in] centres, radii of the balls (length); the references must outlive the grid
  CellGrid(const std::vector<Vector3>& centres, const std::vector<double>& radii)
      : m_centres(centres), m_radii(radii) {
    double largest = 0.0;
    for (const double radius : radii)
      largest = std::fmax(largest, radius);
    m_cell_size = largest > 0.0 ? 2.0 * largest : 1.0;
    for (std::size_t k = 0; k < centres.size(); ++k)
      m_cells[key(cell(centres[k].x), cell(centres[k].y), cell(centres[k].z))].push_back(k);
  }

  /// Calls visit(j) for every ball j != i that overlaps ball i.
  template <class Visitor> void for_neighbours(std::size_t i, const Visitor& visit) const {
    const Vector3& c = m_centres[i];
    for (std::int64_t x = cell(c.x) - 1; x <= cell(c.x) + 1; ++x)
      for (std::int64_t y = cell(c.y) - 1; y <= cell(c.y) + 1; ++y)
        for (std::int64_t z = cell(c.z) - 1; z <= cell(c.z) + 1; ++z)
          visit_cell(i, key(x, y, z), visit);
  }

 private:
  template <class Visitor>
  void visit_cell(std::size_t i, std::uint64_t cell_key, const Visitor& visit) const {
    const auto it = m_cells.find(cell_key);
    if (it == m_cells.end())
      return;
    for (const std::size_t j : it->second) {
      const Vector3 d = m_centres[j] - m_centres[i];
      const double reach = m_radii[i] + m_radii[j];
      if (j != i && dot(d, d) <= reach * reach)
        visit(j);
    }
  }

  /// Number of the cell along one axis; far outliers share the outermost cells.
  std::int64_t cell(double x) const {
    constexpr double farthest = 1.0e6; // cells; 21 bits per axis
    return static_cast<std::int64_t>(
        std::fmax(-farthest, std::fmin(farthest, std::floor(x / m_cell_size))));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::int64_t shift = std::int64_t{1} << 20;
    return (static_cast<std::uint64_t>(x + shift) << 42) |
           (static_cast<std::uint64_t>(y + shift) << 21) | static_cast<std::uint64_t>(z + shift);
  }

  const std::vector<Vector3>& m_centres;
  const std::vector<double>& m_radii;
  double m_cell_size = 1.0;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> m_cells;
};

} // namespace ellipsoid::post
