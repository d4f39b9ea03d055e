// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// One moment of a simulation as its file tells it: named columns of numbers and the box.
#pragma once

#include "input_error.h"
#include "math/vector3.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// The simulation box (length). It begins at `lower`; `upper` is the opposite corner.
struct Box {
  double lower[3] = {0.0, 0.0, 0.0};
  double upper[3] = {0.0, 0.0, 0.0};
  std::string boundary;              ///< as in the file, for example "pp pp ff"
  std::vector<Vector3> tilted_edges; ///< the three edges of a tilted box; empty: along x, y, z
};

struct Frame {
  FileLocation location;      ///< file, line of the frame's first row, number of the frame
  std::int64_t timestep = 0;  ///< of the run
  std::optional<double> time; ///< where the file states it (s)
  std::string units;          ///< where the file states them ("si", "cgs", ...)
  std::string label;          ///< "ATOMS" or the label of a dump local
  Box box;
  std::size_t rows = 0;
  std::vector<std::string> names;           ///< of the columns
  std::vector<std::vector<double>> columns; ///< columns[k][row]
  /// By column: the first value that is no finite number, as a message. Such a column is refused
  /// where it is needed, see find().
  std::vector<std::string> unreadable;
  std::string unread; ///< lines of the rows while they are not in the columns yet, see read_rows()

  /// Index of a column, or -1. Throws InputError for one that holds something else than numbers.
  int find(const std::string& name) const;
  /// Whether all values of a column are numbers.
  bool is_readable(std::size_t column) const {
    return column >= unreadable.size() || unreadable[column].empty();
  }
  /// The values of a column that must be there; `purpose` completes the error message.
  const std::vector<double>& required(const std::string& name, const std::string& purpose) const;
};

} // namespace ellipsoid::post
