// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

namespace ellipsoid {

/// How full a batch is: columns of numbers in which entry k belongs to item k, for loops that the
/// compiler turns into vector instructions.
class Batch {
 public:
  static constexpr int capacity = 64;
  /// A cache line more: columns one power of two apart would all fall on the same few cache sets.
  static constexpr int column_length = capacity + 8;

  int size() const { return size_; }
  bool full() const { return size_ == capacity; }
  void clear() { size_ = 0; }

 protected:
  /// Place of the next item.
  int next() { return size_++; }
  void resize(int size) { size_ = size; }

 private:
  int size_ = 0;
};

/// Fills columns of numbers up to a multiple of `width` with their last row, which is there, so
/// that no loop needs a rest.
/// @return number of rows
template <class Columns> int filled_up(Columns& columns, int size, int width = 8) {
  int filled = size;
  for (; filled % width != 0; ++filled)
    for (auto& column : columns)
      column[filled] = column[size - 1];
  return filled;
}

/// Squares of what numbers changed by.
/// @param[in,out] before becomes `now`
inline void square_changes(const double* now, double* before, int count, double* squares) {
#pragma GCC ivdep
  for (int k = 0; k < count; ++k) {
    const double change = now[k] - before[k];
    squares[k] = change * change;
    before[k] = now[k];
  }
}

} // namespace ellipsoid
