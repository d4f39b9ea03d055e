// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace ellipsoid::post {

/// Something is wrong with the user's data: one line that names the location and what was expected.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A location in a file; lines count from 1, frames from 1.
struct FileLocation {
  std::string file;
  std::size_t line = 0;
  std::size_t frame = 0;
};

/// "FILE:LINE: frame K: expected E, found F"; without line or frame where they are 0.
InputError unexpected(const FileLocation& location, const std::string& expected,
                      const std::string& found);

/// Bytes that cannot be split into lines; which frame they belong to the reader of lines does not
/// know.
class BrokenLine : public InputError {
 public:
  BrokenLine(const FileLocation& where, const std::string& what_expected,
             const std::string& what_found);
  const FileLocation location;
  const std::string expected, found;
};

/// The text for a message: shortened, control characters made visible.
std::string quoted(const std::string& text);

} // namespace ellipsoid::post
