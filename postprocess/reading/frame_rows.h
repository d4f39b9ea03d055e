// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The rows of a frame, from text to columns of numbers.
#pragma once

#include "frame.h"

#include <string_view>
#include <vector>

namespace ellipsoid::post {

/// Reads rows one after the other into the columns of a frame whose header is known.
///
/// Strict: a row has as many values as the header has columns. Anything else throws InputError that
/// names file, line, frame and what was expected. A value that is no finite number makes its column
/// unreadable, see Frame.
class RowReader {
 public:
  /// @param[in,out] frame location (of its first row), rows and names are set; outlives the reader
  explicit RowReader(Frame& frame);

  /// @param[in] line without its end; the byte behind it is readable and no part of a number
  void read(std::string_view line);
  /// Whole lines, their ends included.
  void read_lines(std::string_view text);
  /// To be called after the last row.
  void drop_missing_rows();

 private:
  void set_memory_aside();
  bool parse(std::string_view line);
  void set_unreadable(std::size_t column, std::string_view token);
  FileLocation here() const;
  InputError refused(std::string_view line) const;

  Frame& frame_;
  std::size_t row_ = 0, held_ = 0;
  std::vector<double*> values_; ///< of each column
};

/// Reads the rows that a frame still holds as text, if any. Throws InputError.
void read_rows(Frame& frame);

} // namespace ellipsoid::post
