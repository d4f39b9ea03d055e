// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "command.h"
#include "pile.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// The options of an in-plane pile: wall, floor, cut, outlines.
struct PlaneOptions {
  PileOptions pile;
  double wall = 0.0;
  bool no_wall = false;
  std::string outline = "true";
};
/// The names of the options that add_fit_options() adds, and of those of add_plane_options().
inline const std::vector<std::string> fit_options = {"--cut-bottom", "--cut-top", "--columns"};
inline const std::vector<std::string> plane_options = {"--wall",    "--no-wall",     "--floor",
                                                       "--section", "--cluster-gap", "--outline"};

/// Which particles are a pile, between which wall and floor.
void add_plane_options(CLI::App& command, PlaneOptions& options);
/// What of the free surface the angle of repose is fitted to.
void add_fit_options(CLI::App& command, PlaneOptions& options);
/// What the words say as values.
PileOptions plane_settings(const PlaneOptions& options);

} // namespace ellipsoid::post
