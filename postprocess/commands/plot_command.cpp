// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "csv_table.h"
#include "input_error.h"
#include "messages.h"
#include "option_checks.h"
#include "paper_figures.h"
#include "picture_options.h"
#include "table_charts.h"

#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

struct PlotOptions {
  std::string what; ///< number of a figure, or "curve", or "map"
  TableChart columns;
  std::vector<std::string> files;
  std::string output;
  double aspect_ratio = 2.7 / 1.15;
  int width = 0, height = 700;
};

/// The words that the command takes: figures of the paper, and any columns.
std::vector<std::string> known_words() {
  std::vector<std::string> words{"curve", "map"};
  for (const int number : known_figures)
    words.push_back(std::to_string(number));
  return words;
}

/// Any columns of the files.
void plot_columns(const PlotOptions& options) {
  if (options.columns.x.empty() || options.columns.y.empty())
    throw InputError(options.what + ": give the columns, --x and --y");
  const bool is_map = options.what == "map";
  if (is_map && options.columns.value.empty())
    throw InputError("map: give the column of the colours, --value");
  std::vector<std::string> numbers = options.columns.y;
  numbers.push_back(options.columns.x);
  numbers.insert(numbers.end(), options.columns.margin.begin(), options.columns.margin.end());
  const Table table = read_csv_files(options.files, numbers);
  constexpr int usual_width = 900; // pixels
  const int width = options.width > 0 ? options.width : usual_width;
  const PictureFormat format = picture_format(options.output);
  write_text(options.output, is_map
                                 ? draw_map(format, table, options.columns, width, options.height)
                                 : draw_charts(format, {curve_chart(table, options.columns)}, width,
                                               options.height));
  if (const std::string words = is_map ? left_out_of_map(table, options.columns)
                                       : left_out_of_curves(table, options.columns);
      !words.empty())
    report_warning(words);
  fmt::print(stderr, "picture: {}\n", options.output);
}

void plot(const PlotOptions& options) {
  if (options.what == "curve" || options.what == "map") {
    plot_columns(options);
    return;
  }
  const Table runs = read_csv_files(options.files, figure_columns);
  const int number = std::stoi(options.what);
  if (const std::string words = left_out_of_figures(runs, {number}); !words.empty())
    report_warning(words);
  const auto charts = figure(number, runs, options.aspect_ratio);
  constexpr int panel_width = 900; // pixels
  const int width =
      options.width > 0 ? options.width : panel_width * static_cast<int>(charts.size());
  write_text(options.output,
             draw_charts(picture_format(options.output), charts, width, options.height));
  fmt::print(stderr, "picture: {}\n", options.output);
}

void add_column_options(CLI::App& command, TableChart& columns) {
  command.add_option("--x", columns.x, "column of the abscissa");
  command.add_option("--y", columns.y, "columns of the ordinate, with commas")->delimiter(',');
  command
      .add_option("--margin", columns.margin, "columns of the margins of --y, in its order (curve)")
      ->delimiter(',');
  command.add_option("--group", columns.group, "column that tells curves apart");
  command.add_option("--value", columns.value, "column of the colours of a map");
  command.add_option("--title", columns.title, "words above a curve or map");
}

void refuse_idle_options(const CLI::App& command, const PlotOptions& options) {
  const bool is_curve = options.what == "curve", is_map = options.what == "map";
  if (!is_curve && !is_map)
    refuse_without_effect(command, {"--x", "--y", "--margin", "--group", "--value", "--title"},
                          "on a figure of the paper");
  if (is_map)
    refuse_without_effect(command, {"--group", "--margin"}, "on a map");
  if (is_curve)
    refuse_without_effect(command, {"--value"}, "on a curve");
  if (options.what != "15")
    refuse_without_effect(command, {"--aspect"}, "on anything but figure 15");
  if (options.what == "5")
    refuse_without_effect(command, {"files"}, "on figure 5");
}

} // namespace

void add_plot_command(CLI::App& program, int& /*exit_code*/) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* command = program.add_subcommand(
      "plot",
      "curves and maps of any columns, and figures of the paper with its points beside ours");
  command->footer(
      "curve: the columns --y over the column --x of CSV files, one curve for each value of "
      "--group. map: rectangles about (--x, --y), coloured by --value. Figure 5 needs no files. "
      "12, 13 and 15 take CSV files of `pile --csv` (with --outline ellipse as well for 'MS "
      "ellipse'); 17 and 18 take CSV files with the columns subspheres (empty: smooth, with "
      "surface = smooth) and relative_cpu_time or potential_contacts_per_particle. Error bars and "
      "bands: half range over runs. Open markers and dashed lines: values of the paper's text.");
  command
      ->add_option("figure", options->what,
                   "curve, map, or a figure of the paper: 5, 12, 13, 15, 17 or 18")
      ->required()
      ->check(CLI::IsMember(known_words()));
  add_column_options(*command, options->columns);
  command->add_option("files", options->files, "CSV files");
  command->add_option("--output,-o", options->output, "file name, ends in .svg or .png")
      ->required()
      ->check(picture_name_check());
  command->add_option("--aspect", options->aspect_ratio, "a/b of the particles (figure 15)")
      ->check(CLI::Range(1.0001, 1000.0))
      ->capture_default_str();
  command->add_option("--width", options->width, "pixels (default: 900 a panel)")
      ->check(CLI::Range(200, 20000));
  command->add_option("--height", options->height, "pixels")
      ->check(CLI::Range(200, 20000))
      ->capture_default_str();
  command->callback([command, options] {
    refuse_idle_options(*command, *options);
    plot(*options);
  });
}

} // namespace ellipsoid::post
