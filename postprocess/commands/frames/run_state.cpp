// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "run_state.h"

#include "csv_table.h"
#include "messages.h"

#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mutex>
#include <set>
#include <utility>

namespace ellipsoid::post {

namespace {

/// Once for each folder, from any thread.
bool is_new_folder(const std::string& dump) {
  static std::mutex mutex;
  static std::set<std::string> known;
  const std::lock_guard<std::mutex> lock(mutex);
  return known.insert(std::filesystem::path(dump).parent_path().string()).second;
}

void warn_of_several_logs(const std::string& dump) {
  if (!is_new_folder(dump))
    return;
  const std::vector<std::string> logs = logs_beside(dump);
  if (logs.size() > 1)
    report_warning(fmt::format("{}: several logs lie beside this dump ({}): {} is taken for its "
                               "run",
                               dump, fmt::join(logs, ", "), logs.front()),
                   "logs beside " + dump);
}

} // namespace

std::string log_file_beside(const std::string& dump) {
  warn_of_several_logs(dump);
  return log_beside(dump);
}

const RunLog* log_of(const ChosenFrame& chosen) {
  warn_of_several_logs(chosen.frame.location.file);
  return run_log_of(chosen.frame.location.file);
}

void append_completeness(Row& row, const ChosenFrame& chosen) {
  const RunLog* log = log_of(chosen);
  Value state(std::string("unknown"));
  if (const std::optional<bool> is_complete = log ? log->is_complete() : std::nullopt) {
    state = *is_complete;
    if (!*is_complete)
      report_warning(fmt::format("{}: the run is not complete: {} says that it reached step {} of "
                                 "{}",
                                 chosen.run, log->path, *log->reached_step, *log->wanted_step),
                     "end of " + chosen.run);
  }
  row.push_back({"run_is_complete", "run came to its end", "", std::move(state)});
}

std::vector<std::string> incomplete_runs(const Table& runs) {
  std::vector<std::string> names;
  for (const Row& row : runs.rows) {
    const Value* state = find_value(row, "run_is_complete");
    const Value* run = find_value(row, "run");
    double number = 1.0; // CSV files hold 1 and 0
    if (state && (*state == Value(false) || (as_number(*state, number) && number == 0.0)))
      names.push_back(run ? shown(*run) : "?");
  }
  return names;
}

} // namespace ellipsoid::post
