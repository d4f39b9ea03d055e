// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "picture_options.h"
#include "pile_analysis.h"
#include "pile_commands.h"

#include <memory>

namespace ellipsoid::post {
namespace {

struct PileTableOptions : PileCommandOptions {
  std::string picture;
};

Row pile_row(const PileTableOptions& options, const ChosenFrame& chosen) {
  const PileOptions settings = plane_settings(options.plane);
  const Pile pile = find_pile(chosen.set, settings);
  warn_of_digits(chosen);
  Row row = frame_row(chosen);
  append_pile(row, chosen.set, pile, settings);
  std::string why;
  const std::optional<ReposeAngle> angle = try_repose(pile, settings, &why);
  if (angle)
    append_repose(row, *angle);
  else
    report_warning(chosen.run + ": no angle of repose: " + why);
  append_porosity(row, plane_porosity(pile, settings, porosity_settings(options), angle));
  append_coordination(
      row,
      coordination(chosen.set, pile.members, coordination_settings(options, settings, pile.mean_b)),
      pile.mean_b);
  append_rest(row, check_rest(chosen.set, pile.members, options.gravity));
  if (!options.picture.empty())
    write_pile_picture(options.picture, chosen, pile, settings, angle, {});
  return row;
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
  command->add_option("--picture", options->picture,
                      "draw the pile as well: a name that ends in .svg or .png, see render");
  command->callback([options, &exit_code] {
    exit_code = run_pile_command(options->frames, "Pile",
                                 [&](const ChosenFrame& f) { return pile_row(*options, f); });
  });
}

} // namespace ellipsoid::post
