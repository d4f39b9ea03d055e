// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "coordination.h"
#include "frame_options.h"
#include "plane_options.h"
#include "porosity.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// Options of the commands on in-plane piles; each command adds the groups it uses.
struct PileCommandOptions {
  FrameOptions frames;
  PlaneOptions plane;
  std::string region = "whole";
  double margin = 2.0; ///< of the core, in a
  bool with_walls = false;
  double contact_gap = 0.0;    ///< in b
  std::vector<double> gravity; ///< m/s2, see gravity_of()
};

void add_porosity_options(CLI::App& command, PileCommandOptions& options);
void add_coordination_options(CLI::App& command, PileCommandOptions& options);

/// Refuses --margin without --region core.
void refuse_idle_margin(const CLI::App& command, const PileCommandOptions& options);

PorosityOptions porosity_settings(const PileCommandOptions& options);
CoordinationOptions coordination_settings(const PileCommandOptions& options,
                                          const PileOptions& pile, double mean_b);

} // namespace ellipsoid::post
