// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
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

  /// Calls visit(j) for every ball j > i that overlaps ball i. Candidates are first put into a row
  /// without branches, which no processor could predict.
  template <class Visitor> void for_later_neighbours(std::size_t i, const Visitor& visit) {
    const Columns& columns = m_columns[m_cell_of_ball[i]];
    const Vector3 centre = m_centres[i];
    const double radius = m_radii[i];
    std::size_t found = 0;
    for (const auto& [begin, end] : columns) {
      m_found.resize(std::max(m_found.size(), found + (end - begin) + 1));
      for (std::size_t place = begin; place < end; ++place) {
        const Placed& other = m_placed[place];
        const Vector3 d = other.centre - centre;
        const double reach = radius + other.radius;
        m_found[found] = other.index;
        found += static_cast<std::size_t>(other.index > i) &
                 static_cast<std::size_t>(dot(d, d) <= reach * reach);
      }
    }
    for (std::size_t k = 0; k < found; ++k)
      visit(m_found[k]);
  }

 private:
  /// A ball and its cell; sorted by cell, so that neighbours along y follow each other (piles in a
  /// plane are one cell thick along z).
  struct Ball {
    std::uint64_t cell_key;
    std::size_t index;
  };

  /// A cell has neighbours in 3 x 3 columns of three cells along y each.
  static constexpr std::size_t column_count = 9;
  /// From a cell's key to that of the middle cell of a column (modulo 2^64).
  static std::uint64_t column_shift(std::size_t column) {
    return ((column / 3 - 1) << x_bit) + ((column % 3 - 1) << z_bit);
  }

  /// Places of the balls of a column: from first to second, without it.
  using Columns = std::array<std::pair<std::size_t, std::size_t>, column_count>;
  /// A copy of a ball where neighbours in space are neighbours in memory.
  struct Placed {
    Vector3 centre;
    double radius;
    std::size_t index;
  };

  /// Fills for each cell where the balls of its columns are. Keys only grow from cell to cell, so
  /// each column's place does.
  void find_neighbour_columns() {
    m_cell_of_ball.resize(m_balls.size());
    m_placed.reserve(m_balls.size());
    Columns columns{};
    std::uint64_t last_key = 0;
    for (const Ball& ball : m_balls) {
      if (m_columns.empty() || ball.cell_key != last_key) {
        for (std::size_t k = 0; k < column_count; ++k)
          advance(columns[k], ball.cell_key + column_shift(k));
        m_columns.push_back(columns);
        last_key = ball.cell_key;
      }
      m_cell_of_ball[ball.index] = m_columns.size() - 1;
      m_placed.push_back({m_centres[ball.index], m_radii[ball.index], ball.index});
    }
  }

  /// To the balls of the cell with this key and of its two neighbours along y.
  void advance(std::pair<std::size_t, std::size_t>& column, std::uint64_t middle) const {
    auto& [begin, end] = column;
    while (begin < m_balls.size() && m_balls[begin].cell_key < middle - 1)
      ++begin;
    end = std::max(begin, end);
    while (end < m_balls.size() && m_balls[end].cell_key <= middle + 1)
      ++end;
  }

  static constexpr unsigned x_bit = 42, z_bit = 21; // of a key

  /// Number of the cell along one axis; far outliers share the outermost cells.
  std::int64_t cell(double x) const {
    constexpr double farthest = 1.0e6; // cells; 21 bits per axis
    return static_cast<std::int64_t>(
        std::fmax(-farthest, std::fmin(farthest, std::floor(x / m_cell_size))));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::int64_t shift = std::int64_t{1} << 20;
    return (static_cast<std::uint64_t>(x + shift) << x_bit) |
           (static_cast<std::uint64_t>(z + shift) << z_bit) | static_cast<std::uint64_t>(y + shift);
  }

  const std::vector<Vector3>& m_centres;
  const std::vector<double>& m_radii;
  double m_cell_size = 1.0;
  std::vector<Ball> m_balls;
  std::vector<Placed> m_placed;         ///< in the order of m_balls
  std::vector<Columns> m_columns;       ///< of the cells that are not empty
  std::vector<std::size_t> m_cell_of_ball; ///< index into m_columns
  std::vector<std::size_t> m_found;
};

} // namespace ellipsoid::post
