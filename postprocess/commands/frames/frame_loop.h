// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The loop of all commands on dumps.
#pragma once

#include "frame_options.h"
#include "particles.h"
#include "table.h"

#include <functional>
#include <string>

namespace ellipsoid::post {

/// A chosen frame of a run and its particles.
struct ChosenFrame {
  std::string run; ///< as given by the user
  const Frame& frame;
  const ParticleSet& set;
};

/// Calls `visit` for the chosen frames of all runs. A broken input is reported on standard error
/// after the whole frames before it have been visited; so is an InputError of `visit`.
/// @return exit code
int for_chosen_frames(const FrameOptions& options,
                      const std::function<void(const ChosenFrame&)>& visit);

/// What remains to be done with a measured frame, in the order of the frames.
using Collect = std::function<void()>;

/// The same for several frames at a time: `measure` runs in threads (it must not share data that
/// changes), what it gives is called in the order of the frames.
/// @return exit code
int for_measured_frames(const FrameOptions& options,
                        const std::function<Collect(const ChosenFrame&)>& measure);

/// Columns that every row of a table on frames begins with: run and time step.
Row frame_row(const ChosenFrame& chosen);
/// The same without values, for tables without rows.
Row frame_columns();

} // namespace ellipsoid::post
