// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_stream.h"

#include "byte_source.h"
#include "frame_rows.h"
#include "natural_order.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fmt/format.h>
#include <glob.h>
#include <map>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace ellipsoid::post {
namespace {

bool is_digit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }

std::uint64_t file_size(const std::string& path) {
  struct stat status {};
  const bool is_known = stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
  return is_known ? static_cast<std::uint64_t>(status.st_size) : 0;
}

} // namespace

std::vector<std::string> expand(const std::string& pattern) {
  struct stat described {};
  const bool is_file = stat(pattern.c_str(), &described) == 0; // whose name has such signs
  if (is_file || pattern.find_first_of("*?[") == std::string::npos)
    return {pattern};
  glob_t found{};
  const int status = glob(pattern.c_str(), 0, nullptr, &found);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < found.gl_pathc; ++k)
    names.emplace_back(found.gl_pathv[k]);
  globfree(&found);
  if (status != 0 || names.empty())
    throw InputError(fmt::format("{}: no file matches this pattern", pattern));
  std::sort(names.begin(), names.end(), natural_less);
  return names;
}

namespace {

/// A name with its last run of digits as "*", and that number.
struct NumberedName {
  std::string pattern, number;
};

NumberedName numbered(const std::string& path) {
  const std::size_t name =
      path.find_last_of('/') == std::string::npos ? 0 : path.find_last_of('/') + 1;
  std::size_t end = path.size();
  while (end > name && !is_digit(path[end - 1]))
    --end;
  std::size_t begin = end;
  while (begin > name && is_digit(path[begin - 1]))
    --begin;
  if (begin == end)
    return {path, ""};
  const std::size_t significant = std::min(path.find_first_not_of('0', begin), end - 1);
  return {path.substr(0, begin) + "*" + path.substr(end),
          path.substr(significant, end - significant)};
}

/// Whether the number in a file's name is the time step of its first frame (VTK files do not
/// tell: yes). A file that cannot be read is reported when its frames are.
/// What is no file (a pipe) is not looked into: it can be read once only.
bool names_its_step(const std::string& path, const std::string& number) {
  if (is_vtk_name(path))
    return true;
  struct stat status {};
  if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
    return false;
  try {
    std::string_view line;
    LineReader lines(open_bytes(path), path);
    while (lines.next(line) && (line == "ITEM: UNITS" || line == "ITEM: TIME"))
      if (!lines.next(line))
        return false;
    return line == "ITEM: TIMESTEP" && lines.next(line) && line == number;
  } catch (const InputError&) {
    return false;
  }
}

/// What several files of one run are called together: their pattern, or the first and the last.
std::string common_name(const Run& run) {
  const bool is_pattern = run.name.find_first_of("*?[") != std::string::npos;
  const std::string pattern = numbered(run.files.front()).pattern;
  const bool have_one =
      std::all_of(run.files.begin(), run.files.end(),
                  [&](const std::string& file) { return numbered(file).pattern == pattern; });
  return is_pattern ? run.name : have_one ? pattern : run.files.front() + " to " + run.files.back();
}

} // namespace

namespace {

/// What two names of one file have in common.
std::string identity_of(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? fmt::format("{} {}", status.st_dev, status.st_ino)
                                          : path;
}

/// A run that is named twice would count twice.
void require_once(const std::vector<Run>& runs) {
  std::map<std::string, std::string> known; // names by what they mean
  for (const Run& run : runs)
    for (const std::string& file : run.files) {
      const auto [entry, is_new] = known.emplace(identity_of(file), file);
      if (!is_new)
        throw InputError(entry->second == file ? file + " is named twice: name each file once"
                                               : fmt::format("{} and {} are one file: name it once",
                                                             entry->second, file));
    }
}

} // namespace

std::vector<Run> runs_of(const std::vector<std::string>& arguments, RunGrouping grouping) {
  std::vector<Run> runs;
  std::map<std::string, std::size_t> series; // run by pattern
  for (const std::string& argument : arguments) {
    const std::vector<std::string> files = expand(argument);
    const bool is_pattern = files.size() != 1 || files.front() != argument;
    if (grouping == RunGrouping::one_run && !runs.empty()) {
      runs.front().files.insert(runs.front().files.end(), files.begin(), files.end());
    } else if (grouping == RunGrouping::each_file) {
      for (const std::string& file : files)
        runs.push_back({file, {file}});
    } else if (is_pattern || grouping == RunGrouping::one_run) {
      runs.push_back({argument, files});
    } else {
      const NumberedName name = numbered(argument);
      const bool is_step = !name.number.empty() && names_its_step(argument, name.number);
      const auto known = is_step ? series.find(name.pattern) : series.end();
      if (known != series.end()) {
        runs[known->second].files.push_back(argument);
        runs[known->second].name = name.pattern;
      } else {
        if (is_step)
          series[name.pattern] = runs.size();
        runs.push_back({argument, {argument}});
      }
    }
  }
  require_once(runs);
  for (Run& run : runs) {
    std::sort(run.files.begin(), run.files.end(), natural_less);
    if (run.files.size() > 1)
      run.name = common_name(run);
  }
  return runs;
}

FrameStream::FrameStream(std::vector<std::string> files) : files_(std::move(files)) {
  for (const std::string& file : files_)
    total_bytes_ += file_size(file);
}

bool FrameStream::next(Frame& frame) {
  if (!next_unread(frame))
    return false;
  read_rows(frame);
  return true;
}

bool FrameStream::next_unread(Frame& frame) {
  for (;;) {
    if (!reader_) {
      if (next_file_ == files_.size()) {
        clear_progress();
        return false;
      }
      reader_ = open_frames(files_[next_file_++]);
      is_empty_ = true;
    }
    if (reader_->next_unread(frame)) {
      ++frames_;
      is_empty_ = false;
      show_progress();
      return true;
    }
    bytes_before_ += reader_->consumed();
    reader_.reset();
    if (is_empty_ && files_.size() > 1) // of a single file the caller sees it
      throw InputError(files_[next_file_ - 1] +
                       ": expected at least one frame, found none: the file is empty");
  }
}

void FrameStream::show_progress() {
  constexpr std::uint64_t too_small_to_show = 20'000'000; // bytes: read in a blink
  if (total_bytes_ < too_small_to_show || isatty(STDERR_FILENO) == 0)
    return;
  const std::uint64_t done = bytes_before_ + reader_->consumed();
  const int percent = static_cast<int>(100 * done / total_bytes_);
  if (percent == shown_percent_)
    return;
  shown_percent_ = percent;
  fmt::print(stderr, "\rreading {:3d} %  [{:<25}]  frame {}", percent,
             std::string(static_cast<std::size_t>(std::min(percent, 100)) / 4, '#'), frames_);
  std::fflush(stderr);
}

void FrameStream::clear_progress() {
  if (shown_percent_ >= 0)
    fmt::print(stderr, "\r{:70}\r", "");
  shown_percent_ = -1;
}

} // namespace ellipsoid::post
