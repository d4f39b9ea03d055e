// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_loop.h"
#include "gravity_options.h"
#include "messages.h"
#include "option_checks.h"
#include "picture_options.h"
#include "pile_definitions.h"
#include "pile_measures.h"
#include "pile_options.h"
#include "table_command.h"

#include <memory>

namespace ellipsoid::post {
namespace {

struct PileTableOptions : PileCommandOptions {
  std::string picture;
};

Row pile_row(const PileTableOptions& options, PictureNames& names, const ChosenFrame& chosen) {
  const PileResult result = measure_pile(options, chosen);
  if (!options.picture.empty())
    write_pile_picture(names.next(chosen), chosen, result.pile, result.settings, result.flanks, {});
  return result.row;
}

} // namespace

void add_pile_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<PileTableOptions>();
  CLI::App* command = program.add_subcommand(
      "pile", "angle of repose, porosity, coordination number, overlaps and rest in one table");
  command->footer(std::string(pile_definition) + "\n" + repose_definition + "\n" +
                  porosity_definition + "\n" + coordination_definition);
  add_frame_options(*command, options->frames, FrameUse::table);
  add_plane_options(*command, options->plane);
  add_fit_options(*command, options->plane);
  add_porosity_options(*command, *options);
  add_coordination_options(*command, *options);
  add_gravity_option(*command, options->gravity);
  command
      ->add_option("--picture", options->picture,
                   "draw the pile as well: a name that ends in .svg or .png, see render")
      ->check(picture_name_check());
  command->callback([command, options, &exit_code] {
    refuse_idle_margin(*command, *options);
    if (const std::string problem = film_name_problem(options->frames, options->picture);
        !problem.empty()) {
      report_error(problem);
      exit_code = exit_bad_usage;
      return;
    }
    if (!options->picture.empty()) {
      refuse_without_effect(*command, {"--threads"}, "with --picture");
      options->frames.threads = 1; // names are given in the order of the frames
    }
    PictureNames names(options->picture);
    exit_code = run_table_command(options->frames, "Pile", [&](const ChosenFrame& f) {
      return pile_row(*options, names, f);
    });
  });
}

} // namespace ellipsoid::post
