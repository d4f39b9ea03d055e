// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Histories of the pairs that touch: a row of numbers each, taken when a contact begins and given
// back when it is over. Addresses of rows hold until clear().
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace ellipsoid_host {

class HistoryRows {
 public:
  /// Gives all rows back.
  /// @param[in] length of a row
  void clear(int length) {
    if (length != length_)
      pages_.clear();
    length_ = length;
    used_ = 0;
    free_.clear();
  }
  /// @return the number of a row of zeros, from 1 on
  int allocate() {
    int row = used_ + 1;
    if (free_.empty()) {
      ++used_;
      if (static_cast<std::size_t>(used_) > pages_.size() * rows_of_page)
        pages_.emplace_back(new double[rows_of_page * static_cast<std::size_t>(length_)]);
    } else {
      row = free_.back();
      free_.pop_back();
    }
    std::fill_n(at(row), length_, 0.0);
    return row;
  }
  void free(int row) { free_.push_back(row); }
  double* at(int row) const {
    const auto k = static_cast<std::size_t>(row - 1);
    return &pages_[k / rows_of_page][k % rows_of_page * static_cast<std::size_t>(length_)];
  }
  int length() const { return length_; }

 private:
  static constexpr std::size_t rows_of_page = 1024;
  std::vector<std::unique_ptr<double[]>> pages_;
  std::vector<int> free_;
  int length_ = 0, used_ = 0;
};

} // namespace ellipsoid_host
