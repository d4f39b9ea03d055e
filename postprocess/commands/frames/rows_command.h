// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"
#include "frame_options.h"

#include <functional>
#include <string>
#include <vector>

namespace ellipsoid::post {

enum class FrameOrder {
  any,       ///< frames are measured several at a time
  ascending, ///< one after the other: what is measured depends on the frames before
};

/// Makes some rows per chosen frame and writes the table; rows of good frames are written even if
/// others fail.
/// @return exit code
int run_rows_command(const FrameOptions& options, const std::string& title, FrameOrder order,
                     const std::function<std::vector<Row>(const ChosenFrame&)>& make_rows);

} // namespace ellipsoid::post
