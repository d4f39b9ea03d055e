// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_reader.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Names that match a pattern with * ? [..], in natural order (dump.9 before dump.10); a name
/// without such signs, or of a file that is there, is returned as it is. Throws InputError when
/// nothing matches.
std::vector<std::string> expand(const std::string& pattern);

/// Files of one run and what to call it.
struct Run {
  std::string name;
  std::vector<std::string> files;
};

enum class RunGrouping {
  automatic, ///< a pattern is a run; so are files that differ only in a number that is the time
             ///< step in the file (one file per step); every other file is a run of its own
  each_file, ///< every file is a run
  one_run,   ///< all files together are one run
};

/// Sorts the user's file names and patterns into runs, each in natural order.
std::vector<Run> runs_of(const std::vector<std::string>& arguments, RunGrouping grouping);

/// The frames of one run: one file with many frames, or many files in natural order.
class FrameStream {
 public:
  explicit FrameStream(std::vector<std::string> files);

  /// The next whole frame; false after the last one. Throws InputError.
  bool next(Frame& frame);
  /// The same, but its rows may be left as text, see FrameReader.
  bool next_unread(Frame& frame);

  const std::vector<std::string>& files() const { return files_; }

 private:
  void show_progress();
  void clear_progress();

  std::vector<std::string> files_;
  std::size_t next_file_ = 0, frames_ = 0;
  std::unique_ptr<FrameReader> reader_;
  std::uint64_t total_bytes_ = 0, bytes_before_ = 0;
  int shown_percent_ = -1;
  bool is_empty_ = false; ///< no frame of the present file was seen yet
};

} // namespace ellipsoid::post
