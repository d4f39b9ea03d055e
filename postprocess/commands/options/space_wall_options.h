// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "command.h"
#include "space_walls.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

struct SpaceWallOptions {
  std::vector<double> planes, cylinders, boxes; ///< numbers of several walls in one row
  std::vector<std::string> meshes;              ///< STL files
  double mesh_scale = 1.0;                      ///< factor on the files' lengths
};

/// Adds --plane-wall, --cylinder-wall, --box-wall and --mesh-wall.
void add_space_wall_options(CLI::App& command, SpaceWallOptions& options);

/// The walls of a run as its log names them: planes, cylinders and meshes that rest.
/// Throws InputError for a log without walls, and meshes that are not known from their files.
std::vector<SpaceWall> walls_of_log(const std::string& log);

/// The walls. Throws InputError for normals and axes of length 0, and empty boxes.
std::vector<SpaceWall> space_walls(const SpaceWallOptions& options);

} // namespace ellipsoid::post
