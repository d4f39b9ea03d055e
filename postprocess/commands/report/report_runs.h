// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What a report collects from its runs, one after the other.
#pragma once

#include "pile_measures.h"
#include "pile_options.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

struct ReportOptions : PileCommandOptions {
  std::string output = "report.html";
  std::string title = "Piling of ellipsoids";
  std::vector<std::string> curves, maps; ///< file and columns of several pictures in one row
  std::vector<std::string> tables, views;
};

/// A pile in the plane, as its picture needs it.
struct ReportedPile {
  PileResult measured;
  ParticleSet set;
};

struct ReportedRun {
  Row measures;                     ///< run and time step, particles; of a pile all its measures
  std::optional<ReportedPile> pile; ///< none: particles in space
  std::string picture;              ///< of particles in space: the file's bytes
  std::string title;                ///< of its picture: particles and time
  Row log;                          ///< version, ranks, run time, seeds, variables; empty: no log
  /// What is not as in the paper's problem; none: the log does not tell.
  std::optional<std::vector<std::string>> differences;
  std::string view_page; ///< made by `view`, beside the dump; empty: none

  std::string name() const { return shown(*find_value(measures, "run")); }
};

/// Folders stand for the dumps in them and in their folders: files whose names end in .dump or
/// .dump.gz; one folder is one run.
std::vector<std::string> with_folders_opened(const std::vector<std::string>& arguments);

/// Measures all chosen frames. @param[out] exit_code
std::vector<ReportedRun> reported_runs(const ReportOptions& options, int& exit_code);

/// What tells the runs apart: their names without the folders that all have in common, and without
/// the file's name where it is the same.
std::map<std::string, std::string> short_names(const std::vector<ReportedRun>& runs);

} // namespace ellipsoid::post
