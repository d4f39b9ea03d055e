// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "report_page.h"

#include "command_line.h"
#include "csv_table.h"
#include "messages.h"
#include "paper_figures.h"
#include "pile_definitions.h"
#include "report_pictures.h"
#include "run_state.h"
#include "run_summary.h"
#include "table_charts.h"
#include "version_text.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <sstream>
#include <utility>

namespace ellipsoid::post {
namespace {

const std::vector<std::string> groups = {"surface", "subspheres"};
const std::vector<std::string> quantities = {"repose_angle_deg", "porosity", "zpp", "zss"};

using Names = std::map<std::string, std::string>;

/// The rows of some runs, with short names.
template <class RowOf>
Table table_of(const std::vector<ReportedRun>& runs, const Names& names, const RowOf& row_of) {
  Table table;
  for (const ReportedRun& run : runs)
    if (const Row row = row_of(run); !row.empty())
      table.rows.push_back(row);
  for (Row& row : table.rows)
    for (Quantity& q : row)
      if (q.key == "run")
        q.value = names.at(shown(q.value));
  return table;
}

std::string paragraph(const std::string& words) { return "<p>" + html_safe(words) + "</p>\n"; }

/// Joined by ", ".
std::string listed(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

HtmlPicture drawing(const std::string& svg, const std::string& description) {
  return {svg, "image/svg+xml", description, "", ""};
}

/// Parameters that all runs share in one sentence, the others as a table.
std::string parameters_of(const Table& logs) {
  std::vector<std::string> shared, own;
  for (const Quantity& q : logs.header()) {
    const Value* first = find_value(logs.rows.front(), q.key);
    const bool is_shared = first && q.key != "run" && logs.rows.size() > 1 &&
                           std::all_of(logs.rows.begin(), logs.rows.end(), [&](const Row& row) {
                             const Value* value = find_value(row, q.key);
                             return value && *value == *first;
                           });
    if (is_shared)
      shared.push_back(q.name + " = " + shown(*first));
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
  return (shared.empty() ? "" : paragraph("All runs: " + listed(shared) + ".")) +
         html_whole_table(table, "Parameters, seeds, versions, run times, from the logs");
}

/// What is not as in the paper, runs that differ alike together.
std::string differences_of(const std::vector<ReportedRun>& runs, const Names& names) {
  std::vector<std::pair<std::string, std::vector<std::string>>> sorted; // words, runs
  for (const ReportedRun& run : runs) {
    if (!run.pile || (run.differences && run.differences->empty()))
      continue;
    const std::string words =
        run.differences ? listed(*run.differences)
        : run.log.empty()
            ? "no log beside the dump says what the parameters were"
            : "the log does not name all parameters of inputs/piling.in: another problem";
    const auto known = std::find_if(sorted.begin(), sorted.end(),
                                    [&](const auto& entry) { return entry.first == words; });
    auto& group = known != sorted.end() ? known->second : sorted.emplace_back(words, 0).second;
    group.push_back(names.at(run.name()));
  }
  if (sorted.empty())
    return "";
  std::string text =
      paragraph("Not compared, because not everything is as in the paper:") + "<ul>\n";
  for (const auto& [words, of_runs] : sorted)
    text += "<li>" + html_safe(of_runs.size() == runs.size() ? "all runs" : listed(of_runs)) +
            ": " + html_safe(words) + "</li>\n";
  return text + "</ul>\n";
}

/// The runs whose parameters are the paper's.
std::vector<ReportedRun> as_in_the_paper(const std::vector<ReportedRun>& runs) {
  std::vector<ReportedRun> same;
  for (const ReportedRun& run : runs)
    if (run.pile && run.differences && run.differences->empty())
      same.push_back(run);
  return same;
}

Row measures_of_pile(const ReportedRun& run) { return run.pile ? run.measures : Row(); }

const std::vector<int> pile_figures = {12, 13, 15};

/// The figures that these runs can fill.
std::string figures_of(const Table& piles, PaperPoints points) {
  std::string html;
  if (piles.rows.empty())
    return html;
  for (const int number : pile_figures) {
    try {
      const auto charts = figure(number, piles, 2.7 / 1.15, points);
      html += html_picture(drawing(
          draw_charts(PictureFormat::svg, charts, 900 * static_cast<int>(charts.size()), 700),
          points == PaperPoints::shown
              ? fmt::format("As figure {} of the paper, with its values from the text", number)
              : fmt::format("As figure {} of the paper, without its values", number)));
    } catch (const InputError& error) {
      report_warning(error.what());
    }
  }
  return html;
}

void append_piles(std::vector<HtmlSection>& sections, const std::vector<ReportedRun>& runs,
                  const Names& names) {
  const Table piles = table_of(runs, names, measures_of_pile);
  if (piles.rows.empty())
    return;
  std::string means;
  for (const std::string& run : incomplete_runs(piles))
    means += "<p><strong>The run " + html_safe(run) +
             " did not come to its end; it is among the means.</strong></p>\n";
  means += html_table(summary_for_people(piles, groups, quantities),
                      "Mean and margin (half range, as in the paper) over runs");
  sections.push_back({"Means", means});
  const std::vector<ReportedRun> same = as_in_the_paper(runs);
  std::string compared;
  if (const Table table = compared_with_paper(table_of(same, names, measures_of_pile));
      !table.rows.empty())
    compared = html_table(table, "The paper's values and those of the runs with its parameters");
  sections.push_back({"Compared with the paper", compared + differences_of(runs, names)});
  const bool all_same = same.size() == piles.rows.size();
  const std::string left_out = left_out_of_figures(piles, pile_figures);
  sections.push_back(
      {"Figures", (left_out.empty() ? "" : paragraph(left_out + ".")) +
                      figures_of(drawn_in_figures(piles),
                                 all_same ? PaperPoints::shown : PaperPoints::hidden)});
}

/// What a caption says of rows that are not in its picture.
std::string in_brackets(const std::string& words) {
  return words.empty() ? "" : " (" + words + ")";
}

/// Curves of one or several columns, which are named with commas.
HtmlPicture curves_of(const std::string& file, const std::string& x, const std::string& columns) {
  constexpr int width = 900, height = 600; // pixels
  TableChart what;
  what.x = x;
  std::istringstream words(columns);
  std::string names;
  for (std::string y; std::getline(words, y, ',');) {
    names += (what.y.empty() ? "" : ", ") + label_of_key(y);
    what.y.push_back(y);
  }
  std::vector<std::string> numbers = what.y;
  numbers.push_back(x);
  const Table table = read_csv_files({file}, numbers);
  const Chart chart = curve_chart(table, what);
  return drawing(draw_charts(PictureFormat::svg, {chart}, width, height),
                 fmt::format("{} over {}: {}", names, label_of_key(x), file) +
                     in_brackets(left_out_of_curves(table, what)));
}

/// Tables, curves and maps of any columns of CSV files, as other commands write them.
std::string measures_of(const ReportOptions& options) {
  constexpr int width = 900, height = 600; // pixels
  std::string html;
  for (const std::string& file : options.tables)
    html += html_whole_table(read_csv_files({file}, {}), file);
  std::vector<HtmlPicture> pictures;
  for (std::size_t k = 0; k < options.curves.size(); k += words_of_curve)
    pictures.push_back(curves_of(options.curves[k], options.curves[k + 1], options.curves[k + 2]));
  for (std::size_t k = 0; k < options.maps.size(); k += words_of_map) {
    const std::string &file = options.maps[k], &value = options.maps[k + 3];
    TableChart what;
    what.x = options.maps[k + 1];
    what.y = {options.maps[k + 2]};
    what.value = value;
    const Table table = read_csv_files({file}, {what.x, what.y.front(), value});
    pictures.push_back(drawing(draw_map(PictureFormat::svg, table, what, width, height),
                               fmt::format("{}: {}", label_of_key(value), file) +
                                   in_brackets(left_out_of_map(table, what))));
  }
  return html + (pictures.empty() ? "" : html_pictures(pictures));
}

std::string logs_of(const std::vector<ReportedRun>& runs, const Names& names) {
  std::string text;
  if (const Table logs = table_of(runs, names, [](const ReportedRun& run) { return run.log; });
      !logs.rows.empty())
    text = parameters_of(logs);
  std::vector<std::string> without;
  for (const ReportedRun& run : runs)
    if (run.log.empty())
      without.push_back(names.at(run.name()));
  if (!without.empty())
    text += paragraph("No log file (log.* or *.log) lies beside the dumps of " + listed(without) +
                      ": nothing is known of their parameters, seeds, version and run time.");
  return text;
}

std::string views_of(const ReportOptions& options) {
  std::string links;
  for (const std::string& view : options.views)
    links += "<li><a href=\"" + html_safe(relative_to_report(view, options.output)) + "\">" +
             html_safe(view) + "</a></li>\n";
  return links.empty() ? "" : "<p>Pages to turn and play:</p>\n<ul>\n" + links + "</ul>\n";
}

std::string definitions() {
  std::string text;
  for (const char* definition :
       {pile_definition, repose_definition, porosity_definition, coordination_definition})
    text += paragraph(definition);
  return text;
}

std::string how_made() {
  return "<p>Command line:</p>\n<pre>" + html_safe(command_line()) +
         "</pre>\n<p>Program:</p>\n<pre>" + html_safe(version_text()) + "</pre>\n";
}

} // namespace

std::string report_page(const ReportOptions& options, const std::vector<ReportedRun>& runs) {
  const Names names = short_names(runs);
  const bool has_piles = std::any_of(runs.begin(), runs.end(),
                                     [](const ReportedRun& run) { return run.pile.has_value(); });
  std::vector<HtmlSection> sections;
  append_piles(sections, runs, names);
  sections.push_back({"Measures", measures_of(options)});
  if (!runs.empty()) {
    const std::string scale = has_piles ? paragraph("All piles are drawn to one scale.") : "";
    sections.push_back(
        {has_piles ? "Piles" : "Particles", scale + html_pictures(pictures_of(runs, names))});
  }
  sections.push_back({"Views", views_of(options)});
  if (!runs.empty()) {
    const Table all = table_of(runs, names, [](const ReportedRun& run) { return run.measures; });
    sections.push_back({"Runs", html_whole_table(all, "Last frames of the runs")});
    sections.push_back({"Parameters", logs_of(runs, names)});
  }
  if (has_piles)
    sections.push_back({"Definitions", definitions()});
  sections.push_back({"How this page was made", how_made()});
  sections.erase(std::remove_if(sections.begin(), sections.end(),
                                [](const HtmlSection& section) { return section.body.empty(); }),
                 sections.end());
  return html_page(options.title, sections);
}

std::string relative_to_report(const std::string& path, const std::string& report) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::absolute(fs::path(report)).parent_path();
  const fs::path relative = fs::proximate(fs::absolute(path), folder, error);
  return error ? path : relative.generic_string();
}

} // namespace ellipsoid::post
