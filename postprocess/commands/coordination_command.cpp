// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pile_analysis.h"
#include "pile_commands.h"

#include <memory>

namespace ellipsoid::post {
namespace {

Row coordination_row(const PileCommandOptions& options, const ChosenFrame& chosen) {
  const PileOptions settings = plane_settings(options.plane);
  const Pile pile = find_pile(chosen.set, settings);
  warn_of_digits(chosen);
  const Coordination z =
      coordination(chosen.set, pile.members, coordination_settings(options, settings, pile.mean_b));
  Row row = frame_row(chosen);
  append_pile(row, chosen.set, pile, settings);
  append_coordination(row, z, pile.mean_b);
  append_distribution(row, z);
  return row;
}

} // namespace

void add_coordination_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<PileCommandOptions>();
  CLI::App* command = program.add_subcommand("coordination", "coordination numbers and overlaps");
  command->footer(std::string(pile_definition) + "\n" + coordination_definition);
  add_frame_options(*command, options->frames);
  add_plane_options(*command, options->plane);
  add_coordination_options(*command, *options);
  command->callback([options, &exit_code] {
    exit_code =
        run_pile_command(options->frames, "Coordination numbers",
                         [&](const ChosenFrame& f) { return coordination_row(*options, f); });
  });
}

} // namespace ellipsoid::post
