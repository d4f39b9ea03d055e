// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "run_log.h"

#include "byte_source.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <vector>

namespace ellipsoid::post {
namespace {

/// LIGGGHTS echoes a line before and after each substitution of a variable: the difference of
/// two such lines is the variable's value.
void take_substitution(const std::string& before, const std::string& after, RunLog& log) {
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

RunLog read_run_log(const std::string& path) {
  RunLog log;
  log.path = path;
  LineReader lines(open_bytes(path), path);
  std::string_view view;
  std::string before;
  while (lines.next(view)) {
    const std::string line(view);
    if (log.version.empty() && line.find("LIGGGHTS") != std::string::npos)
      log.version = line;
    take_substitution(before, line, log);
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
