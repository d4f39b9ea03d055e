// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "csv_table.h"
#include "frame_loop.h"
#include "frame_stream.h"
#include "gravity_options.h"
#include "html.h"
#include "messages.h"
#include "paper_figures.h"
#include "picture_options.h"
#include "pile_definitions.h"
#include "pile_measures.h"
#include "pile_options.h"
#include "run_log.h"
#include "run_state.h"
#include "run_summary.h"
#include "table_charts.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>

namespace ellipsoid::post {
namespace {

struct ReportOptions : PileCommandOptions {
  std::string output = "report.html";
  std::string title = "Piling of ellipsoids";
  std::vector<std::string> curves, maps; ///< file and columns of several pictures in one row
};

const std::vector<std::string> groups = {"surface", "subspheres"};
const std::vector<std::string> quantities = {"repose_angle_deg", "porosity", "zpp", "zss"};

/// Folders stand for the dumps in them and in their folders: files whose names end in .dump or
/// .dump.gz; one folder is one run.
std::vector<std::string> with_folders_opened(const std::vector<std::string>& arguments) {
  namespace fs = std::filesystem;
  std::vector<std::string> result;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (!fs::is_directory(argument, error)) {
      result.push_back(argument);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(argument, error)) {
      const std::string name = entry.path().filename().string();
      if (name.find(".dump") != std::string::npos && entry.is_regular_file(error))
        found.push_back(entry.path().string());
    }
    if (found.empty())
      throw InputError(fmt::format("{}: no file *.dump in this folder", argument));
    std::sort(found.begin(), found.end());
    result.insert(result.end(), found.begin(), found.end());
  }
  return result;
}

/// Everything that is collected from the runs.
struct Findings {
  Table runs{"", {}};
  Table logs{"", {}};
  std::vector<std::string> pictures;    ///< SVG, one per run
  std::vector<std::string> without_log; ///< runs
};

Row log_row(const std::string& run, const RunLog& log) {
  Row row = {{"run", "run", "", run}};
  if (!log.version.empty())
    row.push_back({"version", "version", "", log.version});
  if (log.ranks > 0) { // a run that has not ended says nothing of its time
    row.push_back({"ranks", "ranks", "", static_cast<std::int64_t>(log.ranks)});
    row.push_back({"loop_time_s", "run time", "s", log.loop_time});
  }
  for (const auto& [name, value] : log.variables)
    row.push_back({"variable_" + name, name, "", value});
  return row;
}

void visit(const ReportOptions& options, const ChosenFrame& chosen, Findings& findings) {
  const PileResult result = measure_pile(options, chosen);
  findings.runs.rows.push_back(result.row);
  PilePictureOptions picture;
  picture.title = frame_title(chosen);
  findings.pictures.push_back(draw_pile(PictureFormat::svg, chosen.frame, chosen.set, result.pile,
                                        result.settings, result.flanks, picture));
  if (const RunLog* log = run_log_of(chosen.frame.place.file))
    findings.logs.rows.push_back(log_row(chosen.run, *log));
  else
    findings.without_log.push_back(chosen.run);
}

/// What tells the runs apart: their names without the folders that all have in common, and without
/// the file's name where it is the same.
std::map<std::string, std::string> short_names(const Table& runs) {
  namespace fs = std::filesystem;
  std::vector<fs::path> paths;
  for (const Row& row : runs.rows)
    paths.emplace_back(shown(*find_value(row, "run")));
  const auto all_same = [&](const auto& part) {
    return std::all_of(paths.begin(), paths.end(),
                       [&](const fs::path& path) { return part(path) == part(paths.front()); });
  };
  const bool drops_file = paths.size() > 1 && paths.front().has_parent_path() &&
                          all_same([](const fs::path& path) { return path.filename(); });
  std::map<std::string, std::string> names;
  for (const fs::path& path : paths)
    names[path.string()] = (drops_file ? path.parent_path() : path).string();
  const auto first_folder_is_common = [&] {
    const std::string& name = names.begin()->second;
    const std::string folder = name.substr(0, name.find('/') + 1);
    return !folder.empty() && std::all_of(names.begin(), names.end(), [&](const auto& entry) {
      return entry.second.rfind(folder, 0) == 0 && entry.second.size() > folder.size();
    });
  };
  while (first_folder_is_common())
    for (auto& [path, name] : names)
      name.erase(0, name.find('/') + 1);
  return names;
}

/// The rows with short names of the runs.
Table renamed(Table table, const std::map<std::string, std::string>& names) {
  for (Row& row : table.rows)
    for (Quantity& q : row)
      if (q.key == "run")
        q.value = names.at(shown(q.value));
  return table;
}

/// Parameters that all runs share in one sentence, the others as a table.
std::string parameters_of(const Table& logs) {
  std::string shared;
  std::vector<std::string> own;
  for (const Quantity& q : logs.header()) {
    const Value* first = find_value(logs.rows.front(), q.key);
    const bool is_shared = first && q.key != "run" && logs.rows.size() > 1 &&
                           std::all_of(logs.rows.begin(), logs.rows.end(), [&](const Row& row) {
                             const Value* value = find_value(row, q.key);
                             return value && *value == *first;
                           });
    if (is_shared)
      shared += fmt::format("{}{} = {}", shared.empty() ? "" : ", ", q.name, shown(*first));
    else
      own.push_back(q.key);
  }
  Table table;
  for (const Row& row : logs.rows) {
    table.rows.emplace_back();
    for (const Quantity& q : row)
      if (std::find(own.begin(), own.end(), q.key) != own.end())
        table.rows.back().push_back(q);
  }
  return (shared.empty() ? "" : "<p>All runs: " + html_safe(shared) + ".</p>\n") +
         html_table(table);
}

std::string pictures_of(const Findings& findings, const std::map<std::string, std::string>& names) {
  std::string html;
  for (std::size_t k = 0; k < findings.pictures.size(); ++k) {
    const Row& row = findings.runs.rows[k];
    const std::string count = shown(*find_value(row, "subspheres"));
    html += html_picture(findings.pictures[k],
                         fmt::format("{}: {}{}", names.at(shown(*find_value(row, "run"))),
                                     shown(*find_value(row, "surface")),
                                     count == "-" ? "" : ", N = " + count));
  }
  return html;
}

/// The figures that these runs can fill.
std::string figures_of(const Table& runs) {
  std::string html;
  for (const int number : {12, 13, 15}) {
    try {
      const auto charts = figure(number, runs, 2.7 / 1.15);
      html += html_picture(
          draw_charts(PictureFormat::svg, charts, 900 * static_cast<int>(charts.size()), 700),
          fmt::format("Figure {} of the paper, with its values from the text", number));
    } catch (const InputError& error) {
      report_warning(error.what());
    }
  }
  return html;
}

constexpr std::size_t words_of_curve = 3, words_of_map = 4; ///< file and columns

void check(const std::vector<std::string>& words, std::size_t each, const std::string& option) {
  if (words.size() % each != 0)
    throw InputError(fmt::format("{} needs {} words for each picture, found {} altogether", option,
                                 each, words.size()));
}

/// Curves and maps of any columns of CSV files, as other commands write them.
std::string measures_of(const ReportOptions& options) {
  constexpr int width = 900, height = 600; // pixels
  std::string html;
  for (std::size_t k = 0; k < options.curves.size(); k += words_of_curve) {
    const std::string &file = options.curves[k], &x = options.curves[k + 1],
                      &y = options.curves[k + 2];
    const Chart chart = curve_chart(read_csv_files({file}, {x, y}), {x, "", {y}, "", ""});
    html += html_picture(draw_charts(PictureFormat::svg, {chart}, width, height),
                         fmt::format("{} over {}: {}", label_of_key(y), label_of_key(x), file));
  }
  for (std::size_t k = 0; k < options.maps.size(); k += words_of_map) {
    const std::string &file = options.maps[k], &x = options.maps[k + 1], &y = options.maps[k + 2],
                      &value = options.maps[k + 3];
    html += html_picture(draw_map(PictureFormat::svg, read_csv_files({file}, {x, y, value}),
                                  {x, "", {y}, value, ""}, width, height),
                         fmt::format("{}: {}", label_of_key(value), file));
  }
  return html;
}

std::string page(const ReportOptions& options, const Findings& findings) {
  std::string body;
  for (const std::string& run : incomplete_runs(findings.runs))
    body += "<p><strong>The run " + html_safe(run) +
            " did not come to its end; it is among the means.</strong></p>\n";
  body += "<h2>Mean and margin over runs</h2>\n";
  body += html_table(summary_for_people(findings.runs, groups, quantities));
  body += "<p>Margins are half ranges, as in the paper.</p>\n";
  if (const Table compared = compared_with_paper(findings.runs); !compared.rows.empty())
    body += "<h2>Compared with the paper</h2>\n" + html_table(compared);
  body += "<h2>Figures</h2>\n" + figures_of(findings.runs);
  if (const std::string measures = measures_of(options); !measures.empty())
    body += "<h2>Measures</h2>\n" + measures;
  constexpr std::size_t few = 6; // runs side by side on a page
  const auto names = short_names(findings.runs);
  const Table runs = renamed(findings.runs, names);
  body += "<h2>Runs</h2>\n";
  body += runs.rows.size() > few ? html_table(runs) : html_table_beside(runs, "run");
  body += "<h2>Piles</h2>\n" + pictures_of(findings, names);
  body += "<h2>Parameters, versions, run times</h2>\n";
  if (!findings.logs.rows.empty())
    body += parameters_of(renamed(findings.logs, names));
  if (!findings.without_log.empty()) {
    body += "<p>No log file (log.* or *.log) lies beside the dumps of";
    for (const std::string& run : findings.without_log)
      body += " " + html_safe(names.at(run));
    body += ": nothing is known of their parameters, version and run time.</p>\n";
  }
  body += fmt::format("<h2>Definitions</h2>\n<p>{}</p>\n<p>{}</p>\n<p>{}</p>\n<p>{}</p>\n",
                      html_safe(pile_definition), html_safe(repose_definition),
                      html_safe(porosity_definition), html_safe(coordination_definition));
  return html_page(options.title, body);
}

int report(ReportOptions& options) {
  check(options.curves, words_of_curve, "--curve");
  check(options.maps, words_of_map, "--map");
  options.frames.runs = with_folders_opened(options.frames.runs);
  Findings findings;
  const int code = for_chosen_frames(
      options.frames, [&](const ChosenFrame& chosen) { visit(options, chosen, findings); });
  if (findings.runs.rows.empty())
    throw InputError("no run could be measured: there is no report");
  write_text(options.output, page(options, findings));
  fmt::print(stderr, "report: {}\n", options.output);
  write_table(options.frames, findings.runs);
  return code;
}

} // namespace

void add_report_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      program.add_subcommand("report", "one HTML page for many runs: tables, figures, pictures");
  command->footer(
      "A folder stands for all *.dump files in it and below it. Parameters, version and "
      "run time come from the log file (log.* or *.log) beside each run's dump. The "
      "page holds its pictures itself and loads nothing.");
  add_frame_options(*command, options->frames);
  add_plane_options(*command, options->plane);
  add_porosity_options(*command, *options);
  add_coordination_options(*command, *options);
  add_gravity_option(*command, options->gravity);
  command->add_option("--output,-o", options->output, "file name")->capture_default_str();
  command->add_option("--title", options->title, "heading of the page")->capture_default_str();
  command->add_option("--curve", options->curves,
                      "CSV file of any command and two columns: a curve, and more of them");
  command->add_option("--map", options->maps,
                      "CSV file and three columns, x, y and the colours': a map, and more of them");
  command->callback([options, &exit_code] {
    options->frames.quiet = true;
    exit_code = report(*options);
  });
}

} // namespace ellipsoid::post
