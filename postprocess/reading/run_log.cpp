// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "run_log.h"

#include "byte_source.h"
#include "whole_token.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <mutex>
#include <system_error>
#include <vector>

namespace ellipsoid::post {
namespace {

/// LIGGGHTS echoes a line before and after each substitution of a variable: the difference of
/// two such lines is the variable's value.
void record_substitution(const std::string& before, const std::string& after, RunLog& log) {
  const auto begin = before.find("${");
  const auto end = begin == std::string::npos ? begin : before.find('}', begin);
  if (end == std::string::npos)
    return;
  const std::string prefix = before.substr(0, begin), suffix = before.substr(end + 1);
  if (after.size() < prefix.size() + suffix.size() ||
      after.compare(0, prefix.size(), prefix) != 0 ||
      after.compare(after.size() - suffix.size(), suffix.size(), suffix) != 0)
    return;
  log.variables[before.substr(begin + 2, end - begin - 2)] =
      after.substr(prefix.size(), after.size() - prefix.size() - suffix.size());
}

} // namespace

std::optional<bool> RunLog::is_complete() const {
  if (!wanted_step || !reached_step)
    return std::nullopt;
  return *reached_step >= *wanted_step;
}

namespace {

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (auto word = next_token(line); !word.empty(); word = next_token(line))
    words.push_back(word);
  return words;
}

/// "fix ID GROUP gravity G vector X Y Z"
std::optional<Vector3> gravity_of(const std::vector<std::string_view>& words) {
  if (words.size() < 9 || words[0] != "fix" || words[3] != "gravity" || words[5] != "vector")
    return std::nullopt;
  double numbers[4];
  for (std::size_t k = 0; k < 4; ++k) {
    const auto number = whole_token<double>(words[k == 0 ? 4 : k + 5]);
    if (!number)
      return std::nullopt;
    numbers[k] = *number;
  }
  const Vector3 direction{numbers[1], numbers[2], numbers[3]};
  if (!(norm(direction) > 0.0))
    return std::nullopt;
  return numbers[0] * normalized(direction);
}

/// The seed of a fix that draws random numbers: after the style of templates and distributions,
/// else after the word `seed`.
std::optional<std::string_view> seed_of(const std::vector<std::string_view>& words) {
  constexpr std::size_t style = 3; // fix ID GROUP STYLE
  if (words.size() < style + 2 || words[0] != "fix")
    return std::nullopt;
  std::string_view seed;
  for (const std::string_view begin : {"particletemplate/", "particledistribution/"})
    if (words[style].substr(0, begin.size()) == begin)
      seed = words[style + 1];
  for (std::size_t k = style + 1; seed.empty() && k + 1 < words.size(); ++k)
    if (words[k] == "seed")
      seed = words[k + 1];
  return whole_token<std::int64_t>(seed) ? std::optional(seed) : std::nullopt;
}

/// What the lines of a log say, one after the other.
class LogLines {
 public:
  explicit LogLines(RunLog& log) : log_(log) {}

  void read(std::string_view line) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty())
      return;
    if (words[0] == "Step") {
      is_thermo_ = true;
    } else if (words[0] == "Loop") {
      is_thermo_ = false;
    } else if (is_thermo_) {
      read_step(words[0]);
    } else {
      read_command(words);
    }
  }

 private:
  void read_step(std::string_view word) {
    const auto step = whole_token<std::int64_t>(word);
    if (!step)
      return;
    log_.reached_step = step;
    if (steps_)
      log_.wanted_step = *step + *steps_; // the first line: where the run begins
    steps_.reset();
  }
  void read_command(const std::vector<std::string_view>& words) {
    if (words[0] == "timestep" && words.size() > 1) {
      if (const auto value = whole_token<double>(words[1]))
        log_.time_step = value;
    } else if (words[0] == "run" && words.size() > 1) {
      const auto count = whole_token<std::int64_t>(words[1]);
      const bool is_upto = words.size() > 2 && words[2] == "upto";
      if (count && is_upto)
        log_.wanted_step = count;
      steps_ = is_upto ? std::nullopt : count;
    } else if (const auto seed = seed_of(words)) {
      log_.seeds[fmt::format("{} ({})", words[1], words[3])] = std::string(*seed);
    } else if (const auto gravity = gravity_of(words)) {
      // a resumed run appends to its log: the same fix comes again
      gravity_[std::string(words[1])] = *gravity;
      log_.gravity = Vector3{};
      for (const auto& [id, value] : gravity_)
        *log_.gravity += value;
    }
  }

  RunLog& log_;
  bool is_thermo_ = false;
  std::optional<std::int64_t> steps_; ///< of a run whose first line is still to come
  std::map<std::string, Vector3> gravity_;
};

} // namespace

RunLog read_run_log(const std::string& path) {
  RunLog log;
  log.path = path;
  LineReader lines(open_bytes(path), path);
  LogLines meanings(log);
  std::string_view view;
  std::string before;
  while (lines.next(view)) {
    const std::string line(view);
    if (log.version.empty() && line.find("LIGGGHTS") != std::string::npos)
      log.version = line;
    record_substitution(before, line, log);
    meanings.read(line);
    double seconds = 0.0;
    int ranks = 0;
    if (std::sscanf(line.c_str(), "Loop time of %lf on %d procs", &seconds, &ranks) == 2) {
      log.loop_time += seconds;
      log.ranks = ranks;
    }
    before = line;
  }
  return log;
}

const RunLog* run_log_of(const std::string& dump) {
  static std::mutex mutex;
  static std::map<std::string, std::optional<RunLog>> known; // by folder
  const std::string folder = std::filesystem::path(dump).parent_path().string();
  const std::lock_guard<std::mutex> lock(mutex);
  auto found = known.find(folder);
  if (found == known.end()) {
    const std::string path = log_beside(dump);
    found = known
                .emplace(folder,
                         path.empty() ? std::nullopt : std::optional<RunLog>(read_run_log(path)))
                .first;
  }
  return found->second ? &*found->second : nullptr;
}

std::string log_beside(const std::string& dump) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<std::string> found;
  const fs::path folder = fs::path(dump).parent_path();
  for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool is_log = name.rfind("log.", 0) == 0 || entry.path().extension() == ".log";
    if (is_log && entry.is_regular_file(error))
      found.push_back(entry.path().string());
  }
  return found.empty() ? "" : *std::min_element(found.begin(), found.end());
}

} // namespace ellipsoid::post
