// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "time_option.h"

namespace ellipsoid::post {

void add_time_option(CLI::App& command, double& time_step) {
  command
      .add_option("--dt", time_step,
                  "time step (s): gives times in seconds where the file does not state them")
      ->check(CLI::PositiveNumber);
}

std::optional<double> time_of(const Frame& frame, double time_step) {
  if (frame.time && time_step > 0.0)
    throw InputError("--dt is for files that do not state the time; this one does: leave it out");
  if (frame.time)
    return frame.time;
  if (time_step > 0.0)
    return time_step * static_cast<double>(frame.timestep);
  return {};
}

void append_time(Row& row, const Frame& frame, double time_step) {
  if (const std::optional<double> time = time_of(frame, time_step))
    row.push_back({"time_s", "time", "s", *time});
}

} // namespace ellipsoid::post
