// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "csv_table.h"
#include "input_error.h"
#include "messages.h"
#include "output_options.h"
#include "run_state.h"
#include "run_summary.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <set>

namespace ellipsoid::post {
namespace {

struct SummaryOptions {
  OutputOptions output;
  std::vector<std::string> files;
  std::vector<std::string> groups = {"surface", "subspheres"};
  std::vector<std::string> quantities = {"repose_angle_deg", "porosity", "zpp", "zss"};
  bool names_quantities = false, names_groups = false; ///< they are the user's choice
};

bool has_column(const Table& table, const std::string& key) {
  const std::vector<Quantity> header = table.header();
  return std::any_of(header.begin(), header.end(), [&](const Quantity& q) { return q.key == key; });
}

/// Every quantity that the user names must be there; of the usual ones at least one.
void require_columns(const SummaryOptions& options, const Table& runs) {
  const auto is_missing = [&](const std::string& key) { return !has_column(runs, key); };
  const auto begin = options.quantities.begin(), end = options.quantities.end();
  const auto missing = options.names_quantities || std::all_of(begin, end, is_missing)
                           ? std::find_if(begin, end, is_missing)
                           : end;
  if (missing != end)
    throw InputError(fmt::format("{}: expected a column \"{}\" (choose others with --quantity), {}",
                                 options.files.front(), *missing, columns_found(runs)));
}

/// The columns that tell groups apart; files of both outlines are not mixed unless the user says
/// so.
std::vector<std::string> groups_for(const SummaryOptions& options, const Table& runs) {
  std::vector<std::string> groups = options.groups;
  std::set<std::string> outlines;
  for (const Row& row : runs.rows)
    if (const Value* outline = find_value(row, "outline"))
      outlines.insert(shown(*outline));
  if (!options.names_groups && outlines.size() > 1)
    groups.push_back("outline");
  return groups;
}

int summarise(const SummaryOptions& options) {
  const Table runs = read_csv_files(options.files, options.quantities);
  const std::vector<std::string> groups = groups_for(options, runs);
  require_columns(options, runs);
  for (const std::string& run : incomplete_runs(runs))
    report_warning(run + ": this run did not come to its end; it is among the means");
  for (const std::string& key : options.quantities)
    if (const std::string words = runs_without_number(runs, key);
        !words.empty() && (options.names_quantities || has_column(runs, key)))
      report_warning(words + ": not in its mean");
  const Table summary = summary_of(runs, groups, options.quantities);
  if (prints_text(options.output))
    write_text("-", as_text(summary_for_people(runs, groups, options.quantities)));
  OutputOptions files = options.output;
  files.quiet = true;
  write_table(files, summary);
  return exit_good;
}

} // namespace

void add_summary_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<SummaryOptions>();
  CLI::App* command = program.add_subcommand(
      "summary", "mean and margins over runs, from CSV files that `pile --csv` wrote");
  command->footer("Margin: half range (max - min) / 2, as the paper gives uncertainty margins; the "
                  "standard deviation is that of one run (n - 1). Rows with equal values of the "
                  "--group columns form a group; without --group rows of different outlines (true, "
                  "ellipse) are not mixed.");
  command->add_option("files", options->files, "CSV files, one row per run")->required();
  CLI::Option* group =
      command->add_option("--group", options->groups, "columns that tell the groups apart");
  group->delimiter(',')->capture_default_str();
  CLI::Option* quantity =
      command->add_option("--quantity", options->quantities, "columns to average");
  quantity->delimiter(',')->capture_default_str();
  add_output_options(*command, options->output);
  command->callback([options, quantity, group, &exit_code] {
    options->names_quantities = quantity->count() > 0;
    options->names_groups = group->count() > 0;
    exit_code = summarise(*options);
  });
}

} // namespace ellipsoid::post
