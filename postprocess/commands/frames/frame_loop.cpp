// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_loop.h"

#include "chosen_runs.h"
#include "frame_chooser.h"
#include "messages.h"

#include <algorithm>
#include <fmt/format.h>
#include <thread>

namespace ellipsoid::post {
namespace {

RunGrouping grouping_of(const FrameOptions& options) {
  return options.one_run     ? RunGrouping::one_run
         : options.each_file ? RunGrouping::each_file
                             : RunGrouping::automatic;
}

} // namespace

std::vector<Run> runs_of(const FrameOptions& options) {
  std::vector<Run> runs = runs_of(options.runs, grouping_of(options));
  if (options.takes_one_run && runs.size() > 1)
    throw InputError(fmt::format("expected one run, found {}, among them {} and {}: take one at a "
                                 "time, or --one-run if they are parts of one",
                                 runs.size(), runs[0].name, runs[1].name));
  return runs;
}

int for_measured_frames(const FrameOptions& options,
                        const std::function<Collect(const ChosenFrame&)>& measure) {
  const unsigned threads =
      options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  int code = exit_good;
  try {
    std::unique_ptr<WorkerPool> workers;
    if (threads > 1 && options.frames == "all")
      workers = std::make_unique<WorkerPool>(threads);
    for (const Run& run : runs_of(options))
      code = std::max(
          code,
          FrameChooser(options, run.name, workers.get(), 2 * threads, measure).read(run.files));
  } catch (const InputError& error) {
    report_error(error.what());
    code = exit_bad_data;
  }
  return code;
}

int for_chosen_frames(const FrameOptions& options,
                      const std::function<void(const ChosenFrame&)>& visit) {
  FrameOptions one_by_one = options;
  one_by_one.threads = 1;
  return for_measured_frames(one_by_one, [&visit](const ChosenFrame& chosen) {
    visit(chosen);
    return Collect();
  });
}

Row frame_row(const ChosenFrame& chosen) {
  Row row = frame_columns();
  row[0].value = chosen.run;
  row[1].value = chosen.frame.timestep;
  return row;
}

Row frame_columns() { return {{"run", "run", "", {}}, {"timestep", "time step", "", {}}}; }

} // namespace ellipsoid::post
