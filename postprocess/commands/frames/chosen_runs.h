// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_options.h"
#include "frame_stream.h"

#include <vector>

namespace ellipsoid::post {

/// The runs that the options name.
std::vector<Run> runs_of(const FrameOptions& options);

} // namespace ellipsoid::post
