// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_loop.h"
#include "gravity_options.h"
#include "option_checks.h"
#include "report_page.h"

#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

void check(const std::vector<std::string>& words, std::size_t each, const std::string& option) {
  if (words.size() % each != 0)
    throw InputError(fmt::format("{} needs {} words for each picture, found {} altogether", option,
                                 each, words.size()));
}

int report(ReportOptions& options) {
  check(options.curves, words_of_curve, "--curve");
  check(options.maps, words_of_map, "--map");
  const bool has_measures =
      !options.tables.empty() || !options.curves.empty() || !options.maps.empty();
  if (options.frames.runs.empty() && !has_measures)
    throw InputError("there is nothing to report: give dumps of runs, or CSV files with --table, "
                     "--curve or --map");
  options.frames.runs = with_folders_opened(options.frames.runs);
  int code = exit_good;
  std::vector<ReportedRun> runs;
  if (!options.frames.runs.empty()) {
    runs = reported_runs(options, code);
    if (runs.empty())
      throw InputError("no run could be measured: there is no report");
  }
  write_text(options.output, report_page(options, runs));
  fmt::print(stderr, "report: {}\n", options.output);
  Table table{"", {}};
  for (const ReportedRun& run : runs)
    table.rows.push_back(run.measures);
  write_table(options.frames, table);
  return code;
}

} // namespace

void add_report_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      program.add_subcommand("report", "one HTML page for many runs: tables, figures, pictures");
  command->footer(
      "A folder stands for all *.dump files in it and below it. Parameters, seeds, version and "
      "run time come from the log file (log.* or *.log) beside each run's dump. Runs whose "
      "particles lie in one plane z (or with --section) are measured as piles, others are shown. "
      "The page holds its pictures itself and loads nothing.");
  add_frame_options(*command, options->frames, FrameUse::page);
  command->get_option("runs")->required(false);
  add_plane_options(*command, options->plane);
  add_fit_options(*command, options->plane);
  add_porosity_options(*command, *options);
  add_coordination_options(*command, *options);
  add_gravity_option(*command, options->gravity);
  command->add_option("--output,-o", options->output, "file name")->capture_default_str();
  command->add_option("--title", options->title, "heading of the page")->capture_default_str();
  command->add_option("--table", options->tables, "CSV files of any command, as tables");
  command->add_option(
      "--curve", options->curves,
      "CSV file of any command, the column of the abscissa, those of the ordinate with "
      "commas: curves, and more of them");
  command->add_option("--map", options->maps,
                      "CSV file and three columns, x, y and the colours': a map, and more of them");
  command->add_option("--view", options->views,
                      "pages that `view` made, to link to (one beside a dump is found by itself)");
  command->callback([command, options, &exit_code] {
    refuse_idle_margin(*command, *options);
    if (options->frames.runs.empty())
      refuse_without_effect(*command, {"--csv", "--json"}, "without runs");
    options->frames.quiet = true; // the page is for people
    exit_code = report(*options);
  });
}

} // namespace ellipsoid::post
