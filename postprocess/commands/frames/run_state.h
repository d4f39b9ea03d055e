// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"

namespace ellipsoid::post {

/// Whether the run of a frame came to its end, by the log beside the dump: true, false, or
/// "unknown" where there is no log. Warns of a run that did not.
void append_completeness(Row& row, const ChosenFrame& chosen);

/// The runs of a table whose rows say that they did not come to their end.
std::vector<std::string> incomplete_runs(const Table& runs);

} // namespace ellipsoid::post
