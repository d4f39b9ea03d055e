// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

namespace ellipsoid::post {

/// Fills columns of numbers up to whole vectors with their last row, so that no loop needs a rest.
/// @return number of rows
template <class Columns> int filled_up(Columns& columns, int size) {
  constexpr int widest_vector = 8;
  int filled = size;
  for (; filled % widest_vector != 0; ++filled)
    for (auto& column : columns)
      column[filled] = column[size - 1];
  return filled;
}

} // namespace ellipsoid::post
