// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "run_log.h"

#include "byte_source.h"
#include "whole_token.h"

#include <algorithm>
#include <cmath>
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

/// As many words from `first` on, as numbers; nothing if one is missing or is none.
std::vector<double> numbers_of(const std::vector<std::string_view>& words, std::size_t first,
                               std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t k = first; k < words.size() && k < first + count; ++k)
    if (const auto number = whole_token<double>(words[k]))
      numbers.push_back(*number);
  return numbers.size() == count ? numbers : std::vector<double>();
}

Vector3 at_angles(double azimuth_deg, double polar_deg) {
  constexpr double degree = 3.141592653589793238462643 / 180.0;
  const double azimuth = azimuth_deg * degree, polar = polar_deg * degree;
  return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
          std::cos(polar)};
}

/// "fix ID GROUP gravity G" and "vector X Y Z", "spherical PHI THETA" or "chute ANGLE" (deg).
std::optional<Vector3> gravity_of(const std::vector<std::string_view>& words) {
  constexpr std::size_t style = 5;
  const std::vector<double> magnitude = numbers_of(words, style - 1, 1);
  if (words.size() <= style || magnitude.empty())
    return std::nullopt;
  const std::string_view word = words[style];
  const std::size_t count = word == "vector" ? 3 : word == "spherical" ? 2 : 1;
  const std::vector<double> n = numbers_of(words, style + 1, count);
  if (n.empty())
    return std::nullopt;
  if (word == "spherical")
    return magnitude[0] * at_angles(n[0], n[1]);
  if (word == "chute")
    return magnitude[0] * at_angles(0.0, 180.0 - n[0]);
  if (word != "vector" || !(norm(Vector3{n[0], n[1], n[2]}) > 0.0))
    return std::nullopt;
  return magnitude[0] * normalized(Vector3{n[0], n[1], n[2]});
}

bool is_gravity(const std::vector<std::string_view>& words) {
  return words.size() > 4 && words[0] == "fix" && words[3] == "gravity";
}

/// A line with a variable's name comes once more with its value.
bool is_substituted(const std::vector<std::string_view>& words) {
  return std::none_of(words.begin(), words.end(), [](std::string_view word) {
    return word.find('$') != std::string_view::npos;
  });
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
    } else if (!is_thermo_ || !read_step(words[0])) {
      read_command(words); // also behind the lines of a run that was ended by force
    }
  }

 private:
  bool read_step(std::string_view word) {
    const auto step = whole_token<std::int64_t>(word);
    if (!step)
      return false;
    log_.reached_step = step;
    if (steps_)
      log_.wanted_step = *step + *steps_; // the first line: where the run begins
    steps_.reset();
    return true;
  }
  void read_command(const std::vector<std::string_view>& words) {
    if (words[0] == "timestep" && words.size() > 1) {
      if (const auto value = whole_token<double>(words[1]))
        set_time_step(*value);
    } else if (words[0] == "reset_timestep" || (words[0] == "read_restart" && !log_.time_step) ||
               (words[0] == "fix" && words.size() > 3 && words[3].substr(0, 8) == "dt/reset")) {
      set_time_step(std::nullopt); // steps before are of another run, or have other times
    } else if (words[0] == "run" && words.size() > 1) {
      const auto count = whole_token<std::int64_t>(words[1]);
      const bool is_upto = words.size() > 2 && words[2] == "upto";
      if (count && is_upto)
        log_.wanted_step = count;
      steps_ = is_upto ? std::nullopt : count;
    } else if (const auto seed = seed_of(words)) {
      log_.seeds[fmt::format("{} ({})", words[1], words[3])] = std::string(*seed);
    } else if (is_gravity(words) && is_substituted(words)) {
      // a resumed run appends to its log: the same fix comes again
      gravity_[std::string(words[1])] = gravity_of(words);
      gravity_command_ = joined(words);
      sum_gravity();
    } else if (words[0] == "unfix" && words.size() > 1 &&
               gravity_.erase(std::string(words[1])) > 0) {
      sum_gravity();
    }
  }

  void set_time_step(const std::optional<double>& value) {
    has_many_steps_ = has_many_steps_ || !value || (log_.time_step && log_.time_step != value);
    log_.time_step = has_many_steps_ ? std::nullopt : value;
  }

  void sum_gravity() {
    log_.gravity = Vector3{};
    log_.untold_gravity.clear();
    for (const auto& [id, value] : gravity_) {
      *log_.gravity += value.value_or(Vector3{});
      if (!value)
        log_.untold_gravity = gravity_command_;
    }
  }

  static std::string joined(const std::vector<std::string_view>& words) {
    std::string text;
    for (const std::string_view word : words)
      text += (text.empty() ? "" : " ") + std::string(word);
    return text;
  }

  RunLog& log_;
  bool is_thermo_ = false;
  std::optional<std::int64_t> steps_; ///< of a run whose first line is still to come
  bool has_many_steps_ = false;
  std::map<std::string, std::optional<Vector3>> gravity_; ///< by fix; nothing: not told
  std::string gravity_command_;
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
  const std::vector<std::string> logs = logs_beside(dump);
  return logs.empty() ? "" : logs.front();
}

std::vector<std::string> logs_beside(const std::string& dump) {
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
  std::sort(found.begin(), found.end());
  return found;
}

} // namespace ellipsoid::post
