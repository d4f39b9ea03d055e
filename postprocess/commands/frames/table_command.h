// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"
#include "frame_options.h"

namespace ellipsoid::post {

/// Makes one row per chosen frame (in threads, see for_measured_frames) and writes the table; rows
/// of good frames are written even if others fail.
/// @return exit code
int run_table_command(const FrameOptions& options, const std::string& title,
                      const std::function<Row(const ChosenFrame&)>& make_row);

} // namespace ellipsoid::post
