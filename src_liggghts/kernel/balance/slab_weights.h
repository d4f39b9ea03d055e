// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What particles weigh by their position along one direction of a box that is cut by planes: the
// box is divided into thin slabs of equal thickness, and those into the columns that planes across
// the other directions make. Planes lie between slabs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ellipsoid {

class SlabWeights {
 public:
  /// @param[in] columns, slabs numbers >= 1
  SlabWeights(int columns, int slabs)
      : columns_(columns), slabs_(slabs),
        sums_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(slabs), 0.0) {}

  int columns() const { return columns_; }
  int slabs() const { return slabs_; }

  /// @param[in] fraction position in the box from 0 to 1; what lies outside counts as at the end
  /// @param[in] weight >= 0
  void add(int column, double fraction, double weight) {
    const int slab = static_cast<int>(std::clamp(fraction * slabs_, 0.0, slabs_ - 1.0));
    sums_[index(column, slab)] += weight;
  }

  /// Weight of a slab in a column.
  double of(int column, int slab) const { return sums_[index(column, slab)]; }

  /// All weights, slab by slab within column by column: to be added up over ranks.
  std::vector<double>& values() { return sums_; }

 private:
  int columns_, slabs_;
  std::vector<double> sums_;

  std::size_t index(int column, int slab) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(slabs_) +
           static_cast<std::size_t>(slab);
  }
};

} // namespace ellipsoid
