// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// LIGGGHTS and LAMMPS text dumps: `dump custom` and `dump local`, any number of frames.
#pragma once

#include "byte_source.h"
#include "frame_reader.h"

#include <memory>
#include <string>
#include <string_view>

namespace ellipsoid::post {

/// Reads a text dump frame by frame in constant memory.
///
/// Strict: every row is what RowReader asks for, the frame has as many rows as it announces.
/// Anything else throws InputError that names file, line, frame and what was expected; the
/// frames given before stay valid.
class TextDumpReader : public FrameReader {
 public:
  TextDumpReader(std::unique_ptr<ByteSource> source, const std::string& name);
  explicit TextDumpReader(const std::string& path);

  bool next(Frame& frame) override;
  bool next_unread(Frame& frame) override;
  std::uint64_t consumed() const override { return lines_.consumed(); }

 private:
  void read_header(Frame& frame);
  void read_preamble(Frame& frame, std::string_view line);
  bool read_section(Frame& frame, std::string_view title);
  void read_box(Frame& frame, std::string_view title);
  void load_rows(Frame& frame);
  InputError cut_off(const std::string& expected) const;
  bool next_line(std::string_view& line);
  std::string_view line_of(const char* expected);
  double number(std::string_view token, const char* expected) const;
  std::int64_t integer(std::string_view token, const char* expected) const;
  FileLocation here() const;

  LineReader lines_;
  std::size_t frame_ = 0;
  std::string units_; ///< stated once for all frames that follow
};

} // namespace ellipsoid::post
