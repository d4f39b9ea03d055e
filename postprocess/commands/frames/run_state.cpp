// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "run_state.h"

#include "csv_table.h"
#include "messages.h"
#include "run_log.h"

#include <fmt/format.h>
#include <utility>

namespace ellipsoid::post {

void append_completeness(Row& row, const ChosenFrame& chosen) {
  const RunLog* log = run_log_of(chosen.frame.location.file);
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
    double number = 1.0; // in a CSV file
    if (state && (*state == Value(false) || (as_number(*state, number) && number == 0.0)))
      names.push_back(run ? shown(*run) : "?");
  }
  return names;
}

} // namespace ellipsoid::post
