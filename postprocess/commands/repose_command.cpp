// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_loop.h"
#include "measure_rows.h"
#include "pile_definitions.h"
#include "pile_measures.h"
#include "pile_options.h"
#include "plane_options.h"
#include "table_command.h"

#include <memory>

namespace ellipsoid::post {
namespace {

Row repose_row(const PileCommandOptions& options, const ChosenFrame& chosen) {
  const PileOptions settings = plane_settings(options.plane);
  const Pile pile = plane_pile(chosen, settings);
  Row row = frame_row(chosen);
  append_pile(row, chosen.set, pile, settings);
  append_flanks(row, fitted_flanks(pile, settings));
  return row;
}

} // namespace

void add_repose_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<PileCommandOptions>();
  CLI::App* command = program.add_subcommand(
      "repose", "angle of repose of an in-plane pile beside a wall, or of both its flanks");
  command->footer(std::string(pile_definition) + "\n" + repose_definition);
  add_frame_options(*command, options->frames, FrameUse::table);
  add_plane_options(*command, options->plane);
  add_fit_options(*command, options->plane);
  command->callback([options, &exit_code] {
    exit_code = run_table_command(options->frames, "Angle of repose",
                                  [&](const ChosenFrame& f) { return repose_row(*options, f); });
  });
}

} // namespace ellipsoid::post
