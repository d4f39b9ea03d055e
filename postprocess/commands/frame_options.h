// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Options and the loop that all commands on dumps share: which files, which frames, which output.
#pragma once

#include "command.h"
#include "particles.h"
#include "pile.h"
#include "table.h"

#include <functional>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Files, frames and output of a command.
struct FrameOptions {
  std::vector<std::string> runs; ///< files and patterns, see runs_of
  bool one_run = false, each_file = false;
  std::string frames = "last"; ///< "last", "first", "all", or a time step
  ParticleOptions particles;
  std::string spacing_word = "paper";
  std::string csv, json; ///< paths; empty: not wanted
  bool quiet = false;    ///< no table for people
  unsigned threads = 0;  ///< frames measured at the same time; 0: as many as there are processors
};

/// A check of an option's value by a function that throws for what it refuses.
CLI::Validator check_by(std::function<void(const std::string&)> parse);

void add_frame_options(CLI::App& command, FrameOptions& options);
/// Only --csv, --json and --quiet.
void add_output_options(CLI::App& command, FrameOptions& options);

/// The options of an in-plane pile: wall, floor, cut, outlines.
struct PlaneOptions {
  PileOptions pile;
  double wall = 0.0;
  bool no_wall = false;
  std::string outline = "true";
};
void add_plane_options(CLI::App& command, PlaneOptions& options);
/// What the words say as values.
PileOptions plane_settings(const PlaneOptions& options);

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

/// Writes a table as the options ask: text on standard output, CSV, JSON.
void write_table(const FrameOptions& options, const Table& table);

/// Whether tables for people go to standard output.
bool prints_text(const FrameOptions& options);

/// Prints "error: ..." on standard error.
void report_error(const std::string& message);
/// Prints "warning: ..." on standard error; of several with the same `once_for` only the first.
/// From a measure in a thread: when it is the frame's turn.
void report_warning(const std::string& message, const std::string& once_for = "");

} // namespace ellipsoid::post
