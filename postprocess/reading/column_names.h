// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Columns by the names that this program gives them, whatever they are called in the file.
#pragma once

#include "frame.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Columns that have another name in the file: from the name here to the one there.
using ColumnNames = std::map<std::string, std::string>;

/// The names that a file's columns may be given.
extern const std::vector<std::string> known_columns;

/// Reads "NAME=COLUMN" into a map. Throws InputError for a NAME that means nothing here.
void add_column_name(ColumnNames& names, const std::string& assignment);

/// The values of a column, or null.
using Column = const std::vector<double>*;

/// The columns of one vector; null pointers where they are missing.
struct VectorColumns {
  Column x = nullptr, y = nullptr, z = nullptr;
  explicit operator bool() const { return x && y && z; }
  Vector3 at(std::size_t row) const { return {(*x)[row], (*y)[row], (*z)[row]}; }
};

/// Looks columns up in a frame.
class NamedColumns {
 public:
  /// @param[in] frame outlives the object, @param[in] names see ColumnNames
  /// Throws InputError for a column of the user's that is not there.
  NamedColumns(const Frame& frame, const ColumnNames& names);

  /// A column, or null. Throws InputError when it holds something else than numbers.
  Column find(const std::string& name) const;
  VectorColumns find(const std::string& x, const std::string& y, const std::string& z) const;
  /// Whether there is a column, whatever it holds.
  bool has(const std::string& name) const { return index_of(name) >= 0; }
  /// The first value of several columns that is no number, as a message; empty where there is none.
  std::string fault(const std::vector<std::string>& names) const;
  /// Whether the user named the column.
  bool is_assigned(const std::string& name) const { return names_.count(name) > 0; }
  const Frame& frame() const { return frame_; }

 private:
  std::ptrdiff_t index_of(const std::string& name) const;

  const Frame& frame_;
  const ColumnNames& names_;
};

} // namespace ellipsoid::post
