// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "input_error.h"
#include "messages.h"
#include "option_checks.h"
#include "output_options.h"
#include "recommendation.h"
#include "sphere_sets.h"
#include "template_files.h"
#include "whole_token.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <memory>

namespace ellipsoid::post {
namespace {

struct TemplateOptions {
  OutputOptions output;
  double b = 1.15e-3;
  std::vector<double> aspect_ratios = {2.7 / 1.15};
  std::vector<int> counts = {3, 5, 7, 9, 11, 13, 15, 17};
  std::string spacing_word = "paper";
  std::string measure = "area";
  double tolerance = 0.0, compared_tolerance = 0.0, recommended_aspect = 0.0;
  SetOptions sets;
  BodyFiles files;
  std::string mesh, stl;
};

constexpr ShapeMeasure measures[] = {ShapeMeasure::area, ShapeMeasure::volume,
                                     ShapeMeasure::outline};

ShapeMeasure measure_of(const std::string& word) {
  return *std::find_if(std::begin(measures), std::end(measures),
                       [&](ShapeMeasure m) { return word_of(m) == word; });
}

/// A template that is asked for.
struct Wanted {
  double aspect_ratio;
  int count;
};

/// All counts for each aspect ratio, or the count that each aspect ratio needs.
std::vector<Wanted> wanted_templates(const TemplateOptions& options, SphereSpacing spacing) {
  std::vector<Wanted> wanted;
  for (const double s : options.aspect_ratios) {
    if (options.tolerance > 0.0)
      wanted.push_back(
          {s, sphere_count_for(s, measure_of(options.measure), options.tolerance, spacing)});
    else
      for (const int count : options.counts)
        wanted.push_back({s, count});
  }
  return wanted;
}

Row template_row(const MultisphereTemplate& chain, double aspect_ratio) {
  const MultisphereMeasures m = measure(chain);
  return {{"aspect_ratio", "a/b", "", aspect_ratio},
          {"subspheres", "N", "", static_cast<std::int64_t>(chain.count())},
          {"spacing", "spacing", "", word_of(chain.spacing)},
          {"area_m2", "area", "m2", m.area},
          {"volume_m3", "volume", "m3", m.volume},
          {"perimeter_m", "perimeter", "m", m.perimeter},
          {"area_ratio", "area ratio", "", m.area_ratio},
          {"volume_ratio", "volume ratio", "", m.volume_ratio},
          {"perimeter_ratio", "perimeter ratio", "", m.perimeter_ratio},
          {"area_shape_factor", "sf_A (26)", "", m.area_shape_factor},
          {"perimeter_shape_factor", "sf_P (27)", "", m.perimeter_shape_factor},
          {"outline_deviation_b", "outline deviation", "b", m.outline_deviation / chain.b},
          {"outline_rms_b", "outline rms", "b", m.outline_rms / chain.b},
          {"outline_rq_b", "outline Rq", "b", m.outline_rq / chain.b}};
}

/// The templates that the options ask for. One that cannot be built (too few spheres for the
/// aspect ratio) is left out with a warning; if none is left, this is an error.
Table geometry_table(const std::vector<Wanted>& wanted, double b, SphereSpacing spacing) {
  Table table{"Multi-sphere templates", {}};
  for (const auto& [s, count] : wanted) {
    try {
      table.rows.push_back(template_row(make_multisphere(s * b, b, count, spacing), s));
    } catch (const std::invalid_argument& error) {
      report_warning(error.what());
    }
  }
  if (table.rows.empty())
    throw InputError("none of these templates can be built");
  return table;
}

/// The smallest N that each spacing needs for the same tolerance.
Table comparison_table(const TemplateOptions& options) {
  Table table{"Sub-spheres needed", {}};
  const auto integer = [](int value) { return static_cast<std::int64_t>(value); };
  for (const SpacingComparison& row :
       compare_spacings(options.aspect_ratios, options.compared_tolerance))
    table.rows.push_back(
        {{"aspect_ratio", "a/b", "", row.aspect_ratio},
         {"measure", "measure", "", std::string(word_of(row.what))},
         {"paper", "paper", "", integer(row.paper)},
         {"minimax_outline", "minimax_outline", "", integer(row.minimax_outline)},
         {"minimax_outline_saved", "saved", "", integer(row.paper - row.minimax_outline)},
         {"minimax_area", "minimax_area", "", integer(row.minimax_area)},
         {"minimax_area_saved", "saved", "", integer(row.paper - row.minimax_area)}});
  return table;
}

/// N for 2, 5 and 10 % of what geometry and piles tell.
Table recommendation_table(double aspect) {
  Table table{"Sub-spheres recommended", {}};
  for (const Advice& advice : recommend(aspect, {0.02, 0.05, 0.10})) {
    Row row{{"aspect_ratio", "a/b", "", aspect},
            {"quantity", "quantity", "", advice.quantity},
            {"tolerance_percent", "within", "%", 100.0 * advice.tolerance}};
    if (advice.subspheres > 0)
      row.push_back({"subspheres", "N", "", static_cast<std::int64_t>(advice.subspheres)});
    else
      row.push_back({"subspheres", "N", "", std::string("-")});
    row.push_back({"source", "source", "", advice.source});
    table.rows.push_back(row);
  }
  return table;
}

std::vector<const std::string*> files_of(const TemplateOptions& options) {
  std::vector<const std::string*> files;
  for (const std::string* file : {&options.files.multisphere, &options.files.molecule,
                                  &options.files.spheres, &options.mesh, &options.stl})
    if (!file->empty())
      files.push_back(file);
  return files;
}

void write_files(const TemplateOptions& options, const Wanted& wanted, SphereSpacing spacing) {
  const MultisphereTemplate chain =
      make_multisphere(wanted.aspect_ratio * options.b, options.b, wanted.count, spacing);
  const SphereBody body = body_of(chain);
  write_body_files(options.files, body, body.spheres);
  const SurfaceMesh surface = outline_of_revolution(chain);
  write_if_named(options.mesh, vtp_text(surface));
  write_if_named(options.stl, stl_text(surface));
}

/// With --from a number of --spheres is how many are wanted, not a file.
TemplateChoice set_choice(const CLI::App& command, const TemplateOptions& options) {
  const auto given = [&](const char* option, const std::string& value) {
    return command.count(option) > 0 ? value : std::string();
  };
  TemplateChoice choice{options.counts, given("--spacing", options.spacing_word),
                        given("--measure", options.measure), options.tolerance, options.files};
  if (const auto count = whole_token<int>(options.files.spheres);
      count && !options.sets.mesh.empty()) {
    refuse_without_effect(command, {"--subspheres"}, "with a number of --spheres");
    choice.counts = {*count};
    choice.files.spheres.clear();
  }
  return choice;
}

void check_set_options(const CLI::App& command) {
  for (const char* option : {"--b", "--aspect", "--vtp", "--stl"})
    if (command.count(option) > 0)
      throw InputError(
          std::string(option) +
          " is for chains; sets of spheres (--semiaxes, --clump, --from, --needed, --ratios) "
          "do without it");
}

int run(const CLI::App& command, TemplateOptions& options) {
  if (options.sets.are_asked()) {
    check_set_options(command);
    return run_sets(options.sets, set_choice(command, options), options.output);
  }
  if (!options.sets.picture.empty())
    throw InputError("--picture is of a set of spheres: give --semiaxes, --clump or --from");
  if (options.compared_tolerance > 0.0) {
    write_table(options.output, comparison_table(options));
    return exit_good;
  }
  if (options.recommended_aspect > 0.0) {
    write_table(options.output, recommendation_table(options.recommended_aspect));
    return exit_good;
  }
  const SphereSpacing spacing = sphere_spacing_from_word(options.spacing_word);
  const std::vector<const std::string*> files = files_of(options);
  const std::vector<Wanted> wanted = wanted_templates(options, spacing);
  if (!files.empty() && wanted.size() != 1) {
    report_error(
        "files hold one template: give one --aspect, and one --subspheres or a --tolerance");
    return exit_bad_usage;
  }
  for (const std::string* file : files)
    options.output.quiet = options.output.quiet || *file == "-";
  write_table(options.output, geometry_table(wanted, options.b, spacing));
  if (!files.empty())
    write_files(options, wanted.front(), spacing);
  return exit_good;
}

/// The tolerance that stands for a number of spheres, and the mass.
void add_count_options(CLI::App& command, TemplateOptions& options) {
  command
      .add_option("--tolerance", options.tolerance,
                  "instead of --subspheres: the smallest N within this share of the measure")
      ->check(CLI::Range(1e-6, 0.5));
  command
      .add_option("--measure", options.measure,
                  "of --tolerance: area, volume or outline; of sets volume (default) or outline")
      ->check(CLI::IsMember({"area", "volume", "outline"}))
      ->capture_default_str();
  command
      .add_option("--mass", options.files.mass,
                  "of the body (kg): completes the molecule file, prints the words that go with "
                  "--multisphere")
      ->check(CLI::PositiveNumber);
}

void add_file_options(CLI::App& command, TemplateOptions& options) {
  command.add_option("--multisphere", options.files.multisphere,
                     "write x y z r lines for the host's fix particletemplate/multisphere");
  command.add_option("--molecule", options.files.molecule, "write a LAMMPS molecule file");
  command.add_option("--spheres", options.files.spheres,
                     "write the spheres as CSV; with --from a number is --subspheres");
  command.add_option("--vtp", options.mesh, "write the surface for ParaView");
  command.add_option("--stl", options.stl, "write the surface as STL");
}

/// To be added last: they exclude all others.
void add_comparison_options(CLI::App& command, TemplateOptions& options) {
  CLI::Option* compare = command.add_option(
      "--compare-spacings", options.compared_tolerance,
      "table of the smallest N of each spacing within this share of area, volume and outline");
  compare->check(CLI::Range(1e-6, 0.5));
  for (const char* other : {"--b", "--subspheres", "--spacing", "--tolerance", "--measure",
                            "--mass", "--multisphere", "--molecule", "--spheres", "--vtp", "--stl",
                            "--semiaxes", "--clump", "--from", "--needed", "--ratios"})
    compare->excludes(command.get_option(other));
  CLI::Option* recommend = command.add_option(
      "--recommend", options.recommended_aspect,
      "aspect ratio a/b: table of the N for 2, 5 and 10 % by geometry and by the study's piles");
  recommend->check(CLI::Range(1.0001, 1000.0));
  for (const CLI::Option* other : compare->get_excludes())
    recommend->excludes(command.get_option(other->get_name()));
  recommend->excludes(compare)->excludes(command.get_option("--aspect"));
}

/// Options that a set of spheres, or the table of the numbers needed, does not use.
void refuse_idle_options_of_sets(const CLI::App& command, const TemplateOptions& options) {
  if (options.sets.needed_within > 0.0)
    refuse_without_effect(command,
                          {"--aspect", "--b", "--subspheres", "--spacing", "--tolerance",
                           "--measure", "--mass", "--multisphere", "--molecule", "--spheres",
                           "--vtp", "--stl"},
                          "with --needed");
  else if (!options.sets.ratios.empty())
    refuse_without_effect(command,
                          {"--aspect", "--b", "--tolerance", "--measure", "--mass", "--multisphere",
                           "--molecule", "--spheres", "--vtp", "--stl"},
                          "with --ratios");
  else if (options.tolerance > 0.0)
    refuse_without_effect(command, {"--subspheres"}, "with --tolerance");
  else
    refuse_without_effect(command, {"--measure"}, "without --tolerance");
}

void refuse_idle_options(const CLI::App& command, const TemplateOptions& options) {
  if (options.tolerance > 0.0)
    refuse_without_effect(command, {"--subspheres"}, "with --tolerance");
  else
    refuse_without_effect(command, {"--measure"}, "without --tolerance");
  if (options.files.multisphere.empty() && options.files.molecule.empty())
    refuse_without_effect(command, {"--mass"}, "without --multisphere or --molecule");
}

} // namespace

void add_template_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<TemplateOptions>();
  CLI::App* command = program.add_subcommand(
      "template",
      "multi-sphere templates and clumps: geometry, files for LIGGGHTS, LAMMPS, ParaView");
  command->alias("shape");
  command->footer(
      "Area (9), volume (10), perimeter from the cut-off spheres, exact; ratios to the ellipse "
      "(2); shape factors |A_MS - A_ell| / A_ell (26) and |P_MS - P_ell| / P_ell (27); outline "
      "deviation: largest distance between outline and ellipse; outline rms: root-mean-square of "
      "that distance over the outline's length, Rq the same about the mean distance.");
  command->add_option("--b", options->b, "short semi-axis (m)")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--aspect", options->aspect_ratios, "aspect ratios a/b")->delimiter(',');
  command->add_option("--subspheres", options->counts, "numbers N of sub-spheres")->delimiter(',');
  command
      ->add_option(
          "--spacing", options->spacing_word,
          "of chains: " + words_of_chains() +
              " (paper_touching: N = 3; minimax is minimax_outline); with --semiaxes: medial "
              "(default), minimax_volume or these; with --from: medial (default) or minimax_volume")
      ->capture_default_str()
      ->check(check_by([](const std::string& word) { sphere_spacing_from_word(word); }));
  add_set_options(*command, options->sets);
  add_count_options(*command, *options);
  add_file_options(*command, *options);
  add_comparison_options(*command, *options);
  add_output_options(*command, options->output);
  command->callback([command, options, &exit_code] {
    if (options->sets.are_asked())
      refuse_idle_options_of_sets(*command, *options);
    else
      refuse_idle_options(*command, *options);
    exit_code = run(*command, *options);
  });
}

} // namespace ellipsoid::post
