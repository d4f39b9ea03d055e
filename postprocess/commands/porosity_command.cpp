// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_loop.h"
#include "measure_rows.h"
#include "option_checks.h"
#include "pile_definitions.h"
#include "pile_measures.h"
#include "pile_options.h"
#include "plane_options.h"
#include "table_command.h"

#include <memory>

namespace ellipsoid::post {
namespace {

Row porosity_row(const PileCommandOptions& options, const ChosenFrame& chosen) {
  const PileOptions settings = plane_settings(options.plane);
  const Pile pile = plane_pile(chosen, settings);
  Row row = frame_row(chosen);
  append_pile(row, chosen.set, pile, settings);
  append_porosity(
      row, plane_porosity(pile, settings, porosity_settings(options), try_flanks(pile, settings)));
  return row;
}

} // namespace

void add_porosity_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<PileCommandOptions>();
  CLI::App* command = program.add_subcommand("porosity", "porosity of an in-plane pile");
  command->footer(std::string(pile_definition) + "\n" + porosity_definition);
  add_frame_options(*command, options->frames, FrameUse::table);
  add_plane_options(*command, options->plane);
  add_fit_options(*command, options->plane);
  add_porosity_options(*command, *options);
  command->callback([command, options, &exit_code] {
    refuse_idle_margin(*command, *options);
    if (options->region == "whole")
      refuse_without_effect(*command, fit_options, "without --region middle or core");
    exit_code = run_table_command(options->frames, "Porosity",
                                  [&](const ChosenFrame& f) { return porosity_row(*options, f); });
  });
}

} // namespace ellipsoid::post
