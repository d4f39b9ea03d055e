// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"
#include "run_log.h"

namespace ellipsoid::post {

/// The log beside a dump, or an empty string. Warns where there are several.
std::string log_file_beside(const std::string& dump);
/// What it says; null where there is none.
const RunLog* log_of(const ChosenFrame& chosen);

/// Whether the run of a frame came to its end, by the log beside the dump: true, false, or
/// "unknown" where there is no log. Warns of a run that did not.
void append_completeness(Row& row, const ChosenFrame& chosen);

/// The runs of a table whose rows say that they did not come to their end.
std::vector<std::string> incomplete_runs(const Table& runs);

} // namespace ellipsoid::post
