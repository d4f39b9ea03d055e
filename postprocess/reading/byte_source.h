// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Bytes and lines of plain or compressed files, in constant memory.
#pragma once

#include "input_error.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ellipsoid::post {

/// A stream of bytes with a known offset.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Fills up to `size` bytes; 0 means the end. Throws InputError when the device or the
  /// compressed data are broken; its text says what was found.
  virtual std::size_t read(char* buffer, std::size_t size) = 0;
  /// Bytes of the file on disk that have been consumed so far (for the progress bar).
  virtual std::uint64_t consumed() const = 0;
};

/// Opens a file or a pipe, plain or compressed (see decompressed()); "-" is standard input.
std::unique_ptr<ByteSource> open_bytes(const std::string& path);

inline bool starts_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

inline bool is_blank(char letter) { return letter == ' ' || letter == '\t'; }

/// Cuts the next blank-separated token off `rest`; empty at the end.
std::string_view next_token(std::string_view& rest);

/// A line of a file from Windows without the end that is left of it.
inline std::string_view without_return(std::string_view line) {
  return !line.empty() && line.back() == '\r' ? line.substr(0, line.size() - 1) : line;
}

/// Splits a byte source into lines; a line may be of any length up to `longest_line`.
class LineReader {
 public:
  static constexpr std::size_t longest_line = std::size_t{1} << 20;

  LineReader(std::unique_ptr<ByteSource> source, std::string name);

  /// The next line without its end; false at the end of the file. The view is valid until the
  /// next call; the byte behind it is readable and ends a line. Throws BrokenLine for a line that
  /// is too long or holds a NUL byte (binary data), and for a source that is broken.
  bool next(std::string_view& line);

  /// Appends whole lines, their ends included, to a text: at most `most` of them, none that begins
  /// with `stop`, and none after the text has grown beyond `enough` bytes. Whatever is special (the
  /// end of the file, a line without an end, broken data) is left to `next`.
  /// @return how many
  std::size_t append_lines(std::size_t most, std::string_view stop, std::size_t enough,
                           std::string& text);

  /// Whether the line that `next` gave last has an end: the last one of a file that is cut off,
  /// perhaps within a number, has none.
  bool line_has_end() const { return line_has_end_; }
  /// Number of the line that `next` gave last, from 1.
  std::size_t line_number() const { return line_number_; }
  const std::string& name() const { return name_; }
  std::uint64_t consumed() const { return source_->consumed(); }

 private:
  bool refill();
  bool refill_or_leave_to_next();
  FileLocation next_location() const { return {name_, line_number_ + 1, 0}; }
  bool deliver(std::size_t length, std::size_t skipped, std::string_view& line);

  std::unique_ptr<ByteSource> source_;
  std::string name_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0, line_number_ = 0;
  bool at_end_ = false, line_has_end_ = true;
  std::optional<BrokenLine> broken_; ///< what reading the source ended with
};

/// Text that is none.
BrokenLine nul_byte(const FileLocation& location);

} // namespace ellipsoid::post
