// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which parts of space are occupied: bodies of any sizes in grids, one grid for each power of two
// of their bounding radius, so that a small body beside large ones (or the other way round) meets
// few cells.
#pragma once

#include "insertion/solid_body.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace ellipsoid {

class OccupiedSpace {
 public:
  void add(const SolidBody& body);
  /// Whether the body overlaps none of those added.
  bool is_free(const SolidBody& body) const;
  std::size_t size() const { return bodies_.size(); }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };
  /// Bodies with bounding radii up to half the cell's length, by the cell of their centre.
  using Grid = std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash>;

  std::vector<SolidBody> bodies_;
  std::map<int, Grid> grids_; // by the exponent of the cell's length

  static Cell cell_at(const Vector3& point, double length);
  bool is_free_in(const Grid& grid, double length, const SolidBody& body) const;
  bool is_free_of(const std::vector<std::uint32_t>& others, const SolidBody& body) const;
};

} // namespace ellipsoid
