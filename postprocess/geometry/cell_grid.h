// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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
    m_balls.reserve(centres.size());
    for (std::size_t k = 0; k < centres.size(); ++k)
      m_balls.push_back({key(cell(centres[k].x), cell(centres[k].y), cell(centres[k].z)), k});
    std::sort(m_balls.begin(), m_balls.end(), [](const Ball& p, const Ball& q) {
      return p.cell_key < q.cell_key || (p.cell_key == q.cell_key && p.index < q.index);
    });
    find_neighbour_columns();
  }

  /// Calls visit(j) for every ball j > i that overlaps ball i.
  template <class Visitor> void for_later_neighbours(std::size_t i, const Visitor& visit) const {
    const std::size_t home = m_cell_of_ball[i];
    for (std::size_t k = 0; k < column_count; ++k) {
      const std::uint64_t last = m_cell_keys[home] + column_shift(k) + 1;
      for (std::size_t place = m_columns[home][k];
           place < m_balls.size() && m_balls[place].cell_key <= last; ++place) {
        const std::size_t j = m_balls[place].index;
        if (j <= i)
          continue;
        const Vector3 d = m_centres[j] - m_centres[i];
        const double reach = m_radii[i] + m_radii[j];
        if (dot(d, d) <= reach * reach)
          visit(j);
      }
    }
  }

 private:
  /// A ball and its cell; sorted by cell, so that neighbours along z follow each other.
  struct Ball {
    std::uint64_t cell_key;
    std::size_t index;
  };

  /// A cell has neighbours in 3 x 3 columns of three cells along z each.
  static constexpr std::size_t column_count = 9;
  /// From a cell's key to that of the middle cell of a column (modulo 2^64).
  static std::uint64_t column_shift(std::size_t column) {
    return ((column / 3 - 1) << x_bit) + ((column % 3 - 1) << y_bit);
  }

  /// Fills for each cell where the balls of its columns begin. Keys only grow from cell to cell, so
  /// each column's place does.
  void find_neighbour_columns() {
    m_cell_of_ball.resize(m_balls.size());
    std::array<std::size_t, column_count> places{};
    for (const Ball& ball : m_balls) {
      if (m_cell_keys.empty() || ball.cell_key != m_cell_keys.back()) {
        for (std::size_t k = 0; k < column_count; ++k) {
          const std::uint64_t first = ball.cell_key + column_shift(k) - 1;
          while (places[k] < m_balls.size() && m_balls[places[k]].cell_key < first)
            ++places[k];
        }
        m_cell_keys.push_back(ball.cell_key);
        m_columns.push_back(places);
      }
      m_cell_of_ball[ball.index] = m_cell_keys.size() - 1;
    }
  }

  static constexpr unsigned x_bit = 42, y_bit = 21; // of a key

  /// Number of the cell along one axis; far outliers share the outermost cells.
  std::int64_t cell(double x) const {
    constexpr double farthest = 1.0e6; // cells; 21 bits per axis
    return static_cast<std::int64_t>(
        std::fmax(-farthest, std::fmin(farthest, std::floor(x / m_cell_size))));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::int64_t shift = std::int64_t{1} << 20;
    return (static_cast<std::uint64_t>(x + shift) << x_bit) |
           (static_cast<std::uint64_t>(y + shift) << y_bit) | static_cast<std::uint64_t>(z + shift);
  }

  const std::vector<Vector3>& m_centres;
  const std::vector<double>& m_radii;
  double m_cell_size = 1.0;
  std::vector<Ball> m_balls;
  std::vector<std::uint64_t> m_cell_keys; ///< of the cells that are not empty, ascending
  std::vector<std::array<std::size_t, column_count>> m_columns; ///< of each of these cells
  std::vector<std::size_t> m_cell_of_ball;
};

} // namespace ellipsoid::post
