// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "math/vector3.h"

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
      : centres_(centres), radii_(radii) {
    cell_of_ball_.reserve(centres.size());
    double largest = 0.0;
    for (const double radius : radii)
      largest = std::fmax(largest, radius);
    cell_size_ = largest > 0.0 ? 2.0 * largest : 1.0;
    std::vector<Cell> cells;
    cells.reserve(centres.size());
    for (const Vector3& centre : centres)
      cells.push_back({cell(centre.x), cell(centre.y), cell(centre.z)});
    if (!number_cells(cells))
      sort_cells(cells);
  }

  /// Calls visit(i, j) once for every pair of balls that overlap, i < j. Candidates are first put
  /// into a row without branches, which no processor could predict.
  template <class Visitor> void for_pairs(const Visitor& visit) {
    constexpr std::size_t own = 4, above_in_z = 5, above_in_x = 6, above_in_x_flat = 7;
    for (std::size_t n = 0; n < placed_.size(); ++n) {
      const Placed& ball = placed_[n];
      const std::size_t home = cell_of_ball_[ball.index];
      // half of the neighbours: those behind the ball in its own column, and the columns behind
      std::size_t found = scan(ball, {n + 1, column(home, own).second}, 0);
      if (is_flat_) {
        found = scan(ball, column(home, above_in_x_flat), found);
      } else {
        found = scan(ball, column(home, above_in_z), found);
        for (std::size_t k = above_in_x; k < column_count; ++k)
          found = scan(ball, column(home, k), found);
      }
      for (std::size_t k = 0; k < found; ++k)
        visit(std::min(ball.index, found_[k]), std::max(ball.index, found_[k]));
    }
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
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
  /// Range of the balls of a column: from first to second, without it.
  using Range = std::pair<std::size_t, std::size_t>;
  using Columns = std::array<Range, column_count>;

  /// Column k of the neighbours of a cell: looked up where the cells are numbered.
  Range column(std::size_t home, std::size_t k) const {
    if (starts_.empty())
      return columns_[home][k];
    const std::size_t middle = home + (k / 3) * step_x_ + (k % 3) * step_z_;
    return {starts_[middle - step_x_ - step_z_ - 1], starts_[middle - step_x_ - step_z_ + 2]};
  }

  /// Puts the balls in order by counting those of each cell of the surrounding box (and of an empty
  /// layer around it); false where the box would have far more cells than there are balls.
  bool number_cells(const std::vector<Cell>& cells) {
    if (cells.empty())
      return true;
    Cell lower = cells.front(), upper = lower;
    for (const Cell& c : cells) {
      lower = {std::min(lower.x, c.x), std::min(lower.y, c.y), std::min(lower.z, c.z)};
      upper = {std::max(upper.x, c.x), std::max(upper.y, c.y), std::max(upper.z, c.z)};
    }
    const auto along = [](std::int64_t from, std::int64_t to) {
      return static_cast<std::size_t>(to - from + 3);
    };
    const std::size_t most = 1000 + 20 * cells.size();
    is_flat_ = lower.z == upper.z;
    step_z_ = along(lower.y, upper.y);
    step_x_ = step_z_ * along(lower.z, upper.z); // at most 4e12: no overflow
    if (step_x_ > most || step_x_ * along(lower.x, upper.x) > most)
      return false;
    starts_.assign(step_x_ * along(lower.x, upper.x) + 1, 0);
    for (const Cell& c : cells) {
      cell_of_ball_.push_back(static_cast<std::size_t>(c.x - lower.x + 1) * step_x_ +
                              static_cast<std::size_t>(c.z - lower.z + 1) * step_z_ +
                              static_cast<std::size_t>(c.y - lower.y + 1));
      ++starts_[cell_of_ball_.back()];
    }
    std::size_t end = 0;
    for (std::size_t& start : starts_)
      start = end += start; // of the cell's last ball, plus one
    placed_.resize(cells.size());
    for (std::size_t k = cells.size(); k-- > 0;)
      placed_[--starts_[cell_of_ball_[k]]] = {centres_[k], radii_[k], k};
    return true;
  }

  /// Puts the balls in order by sorting them.
  void sort_cells(const std::vector<Cell>& cells) {
    for (std::size_t k = 0; k < cells.size(); ++k)
      balls_.push_back({key(cells[k].x, cells[k].y, cells[k].z), k});
    std::sort(balls_.begin(), balls_.end(), [](const Ball& p, const Ball& q) {
      return p.cell_key < q.cell_key || (p.cell_key == q.cell_key && p.index < q.index);
    });
    find_neighbour_columns();
  }

  /// A copy of a ball where neighbours in space are neighbours in memory.
  struct Placed {
    Vector3 centre;
    double radius;
    std::size_t index;
  };

  /// Adds the balls in a range that overlap one to those found.
  /// @return number of those found
  std::size_t scan(const Placed& ball, const Range& range, std::size_t found) {
    const auto [begin, end] = range;
    if (found_.size() < found + (end - begin) + 1)
      found_.resize(2 * (found + (end - begin) + 1));
    const Vector3 centre = ball.centre;
    const double radius = ball.radius;
    for (std::size_t k = begin; k < end; ++k) {
      const Placed& other = placed_[k];
      const Vector3 d = other.centre - centre;
      const double reach = radius + other.radius;
      found_[found] = other.index;
      found += static_cast<std::size_t>(dot(d, d) <= reach * reach);
    }
    return found;
  }

  /// Fills for each cell where the balls of its columns are. Keys only grow from cell to cell, so
  /// each column's range does.
  void find_neighbour_columns() {
    cell_of_ball_.resize(balls_.size());
    placed_.reserve(balls_.size());
    Columns columns{};
    std::uint64_t last_key = 0;
    for (const Ball& ball : balls_) {
      if (columns_.empty() || ball.cell_key != last_key) {
        for (std::size_t k = 0; k < column_count; ++k)
          advance(columns[k], ball.cell_key + column_shift(k));
        columns_.push_back(columns);
        last_key = ball.cell_key;
      }
      cell_of_ball_[ball.index] = columns_.size() - 1;
      placed_.push_back({centres_[ball.index], radii_[ball.index], ball.index});
    }
  }

  /// To the balls of the cell with this key and of its two neighbours along y.
  void advance(Range& range, std::uint64_t middle) const {
    auto& [begin, end] = range;
    while (begin < balls_.size() && balls_[begin].cell_key < middle - 1)
      ++begin;
    end = std::max(begin, end);
    while (end < balls_.size() && balls_[end].cell_key <= middle + 1)
      ++end;
  }

  static constexpr unsigned x_bit = 42, z_bit = 21; // of a key

  /// Number of the cell along one axis; far outliers share the outermost cells.
  std::int64_t cell(double x) const {
    constexpr double farthest = 1.0e6; // cells; 21 bits per axis
    return static_cast<std::int64_t>(
        std::fmax(-farthest, std::fmin(farthest, std::floor(x / cell_size_))));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::int64_t shift = std::int64_t{1} << 20;
    return (static_cast<std::uint64_t>(x + shift) << x_bit) |
           (static_cast<std::uint64_t>(z + shift) << z_bit) | static_cast<std::uint64_t>(y + shift);
  }

  const std::vector<Vector3>& centres_;
  const std::vector<double>& radii_;
  double cell_size_ = 1.0;
  std::vector<Placed> placed_;            ///< balls, cell by cell
  std::vector<std::size_t> cell_of_ball_; ///< number of its cell, or index into columns_
  // numbered cells
  bool is_flat_ = false;                ///< one cell along z
  std::size_t step_x_ = 0, step_z_ = 0; ///< from a cell to the next one along x, z
  std::vector<std::size_t> starts_;     ///< of each cell in placed_
  // sorted cells
  std::vector<Ball> balls_;
  std::vector<Columns> columns_;   ///< of the cells that are not empty
  std::vector<std::size_t> found_; ///< neighbours of a ball
};

} // namespace ellipsoid::post
