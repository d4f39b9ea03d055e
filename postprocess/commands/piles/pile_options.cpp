// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pile_options.h"

#include "option_checks.h"

#include "measure_rows.h"

namespace ellipsoid::post {

void add_porosity_options(CLI::App& command, PileCommandOptions& options) {
  command.add_option("--region", options.region, "whole, middle or core")
      ->check(CLI::IsMember({"whole", "middle", "core"}))
      ->capture_default_str();
  command.add_option("--margin", options.margin, "of the core, in mean largest semi-axes a")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void add_coordination_options(CLI::App& command, PileCommandOptions& options) {
  command.add_flag("--with-walls", options.with_walls, "count contacts with wall and floor");
  command
      .add_option("--contact-gap", options.contact_gap,
                  "particles this close (in b) count as touching")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

void refuse_idle_margin(const CLI::App& command, const PileCommandOptions& options) {
  if (options.region != "core")
    refuse_without_effect(command, {"--margin"}, "without --region core");
}

PorosityOptions porosity_settings(const PileCommandOptions& options) {
  PorosityOptions result;
  result.margin = options.margin;
  if (options.region == "middle")
    result.region = PorosityRegion::middle;
  else if (options.region == "core")
    result.region = PorosityRegion::core;
  return result;
}

CoordinationOptions coordination_settings(const PileCommandOptions& options,
                                          const PileOptions& pile, double mean_b) {
  CoordinationOptions result;
  result.count_walls = options.with_walls;
  for (const PlaneWall& wall : walls_of(pile))
    result.walls.push_back(wall);
  result.gap = options.contact_gap * mean_b;
  return result;
}

} // namespace ellipsoid::post
