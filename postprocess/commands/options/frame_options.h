// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Options that all commands on dumps share: which files, which frames, which output.
#pragma once

#include "output_options.h"
#include "particles.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// Files, frames and output of a command.
struct FrameOptions : OutputOptions {
  std::vector<std::string> runs; ///< files and patterns, see runs_of
  bool one_run = false, each_file = false;
  std::string frames = "last"; ///< "last", "first", "all", or a time step
  ParticleOptions particles;
  bool takes_one_run = false; ///< several are refused
  unsigned threads = 0; ///< frames measured at the same time; 0: as many as there are processors
};

/// What a command makes of its frames.
enum class FrameUse {
  table,     ///< a table, its frames measured several at a time: --threads
  rows,      ///< a table, frame after frame
  page,      ///< a page, and its table as files only
  pictures,  ///< no table
  one_series ///< no table, of one run: several are refused
};

/// Adds what the frames' use has an effect of. --threads is refused without --frame all.
void add_frame_options(CLI::App& command, FrameOptions& options, FrameUse use);

} // namespace ellipsoid::post
