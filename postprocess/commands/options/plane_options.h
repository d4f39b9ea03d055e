// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "command.h"
#include "pile.h"

#include <string>

namespace ellipsoid::post {

/// The options of an in-plane pile: wall, floor, cut, outlines.
struct PlaneOptions {
  PileOptions pile;
  double wall = 0.0;
  bool no_wall = false;
  std::string outline = "true";
};
void add_plane_options(CLI::App& command, PlaneOptions& options);
/// What the words say as values.
PileOptions plane_settings(const PlaneOptions& options);

} // namespace ellipsoid::post
