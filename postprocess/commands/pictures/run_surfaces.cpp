// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "run_surfaces.h"

#include "messages.h"
#include "run_state.h"

#include <filesystem>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

std::string name_of(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

void add_meshes_of_run(const RunWalls& walls, const std::string& log, RunSurfaces& surfaces) {
  for (const RunMesh& mesh : walls.meshes) {
    const std::string reason = why_unknown(mesh, log);
    const std::string words =
        fmt::format("mesh {} ({}) is not shown: {}; give it as it is in space by --mesh", mesh.id,
                    mesh.file, reason);
    if (reason.empty())
      surfaces.meshes.push_back({name_of(mesh.file), triangles_of(mesh, log)});
    else
      report_warning(words, words);
  }
}

} // namespace

CLI::Option* add_run_surface_options(CLI::App& command, RunSurfaceOptions& options) {
  CLI::Option* log =
      command.add_option("--log", options.log, "the run's log, for its walls and meshes")
          ->check(CLI::ExistingFile)
          ->default_str("the log beside the first file, if there is one");
  command.add_option("--mesh", options.meshes, "STL files to show, in place of the log's meshes")
      ->check(CLI::ExistingFile);
  return log;
}

RunSurfaces run_surfaces(const RunSurfaceOptions& options, const std::string& dump,
                         bool without_log) {
  RunSurfaces surfaces;
  for (const std::string& mesh : options.meshes)
    surfaces.meshes.push_back({name_of(mesh), read_stl(mesh)});
  const std::string log = options.log.empty() ? log_file_beside(dump) : options.log;
  if (without_log || log.empty())
    return surfaces;
  const RunWalls walls = read_run_walls(log);
  surfaces.planes = walls.planes;
  surfaces.cylinders = walls.cylinders;
  if (options.meshes.empty())
    add_meshes_of_run(walls, log, surfaces);
  return surfaces;
}

} // namespace ellipsoid::post
