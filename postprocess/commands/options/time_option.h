// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "command.h"
#include "frame.h"
#include "table.h"

#include <optional>

namespace ellipsoid::post {

/// Adds --dt: the time step (s), for files that do not state the time.
void add_time_option(CLI::App& command, double& time_step);

/// The time of a frame (s), where the file states it or a time step is known.
std::optional<double> time_of(const Frame& frame, double time_step);

/// Adds a column "time_s" where the time is known.
void append_time(Row& row, const Frame& frame, double time_step);

} // namespace ellipsoid::post
