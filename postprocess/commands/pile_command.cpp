// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_loop.h"
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

Row pile_row(const PileTableOptions& options, const ChosenFrame& chosen) {
  const PileResult result = measure_pile(options, chosen);
  if (!options.picture.empty())
    write_pile_picture(options.picture, chosen, result.pile, result.settings, result.flanks, {});
  return result.row;
}

} // namespace

void add_pile_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<PileTableOptions>();
  CLI::App* command = program.add_subcommand(
      "pile", "angle of repose, porosity, coordination number, overlaps and rest in one table");
  command->footer(std::string(pile_definition) + "\n" + repose_definition + "\n" +
                  porosity_definition + "\n" + coordination_definition);
  add_frame_options(*command, options->frames);
  add_plane_options(*command, options->plane);
  add_porosity_options(*command, *options);
  add_coordination_options(*command, *options);
  add_rest_options(*command, *options);
  command
      ->add_option("--picture", options->picture,
                   "draw the pile as well: a name that ends in .svg or .png, see render")
      ->check(picture_name_check());
  command->callback([options, &exit_code] {
    if (!options->picture.empty())
      options->frames.threads = 1; // pictures may have the same name: the last frame's remains
    exit_code = run_table_command(options->frames, "Pile",
                                  [&](const ChosenFrame& f) { return pile_row(*options, f); });
  });
}

} // namespace ellipsoid::post
