// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Walls and meshes of a run, for pictures: those of its log, and STL files that the user names.
#pragma once

#include "command.h"
#include "run_walls.h"
#include "stl_mesh.h"

#include <array>
#include <string>
#include <vector>

namespace ellipsoid::post {

struct RunSurfaceOptions {
  std::string log; ///< empty: the one beside the dump
  std::vector<std::string> meshes;
};

/// Adds --log and --mesh. @return --log, for options that exclude it
CLI::Option* add_run_surface_options(CLI::App& command, RunSurfaceOptions& options);

struct ShownMesh {
  std::string name;
  std::vector<std::array<Vector3, 3>> triangles; ///< in space (length)
};

struct RunSurfaces {
  std::vector<PrimitivePlane> planes;
  std::vector<PrimitiveCylinder> cylinders;
  std::vector<ShownMesh> meshes;
};

/// The meshes that the user names; and unless `without_log` planes and cylinders of the log, and
/// its meshes where the user names none. A warning names meshes of the log that cannot be shown as
/// they lie.
/// @param[in] dump a file of the run
RunSurfaces run_surfaces(const RunSurfaceOptions& options, const std::string& dump,
                         bool without_log);

} // namespace ellipsoid::post
