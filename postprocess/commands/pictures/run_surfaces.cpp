// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "run_surfaces.h"

#include "messages.h"
#include "run_log.h"

#include <filesystem>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

ShownMesh mesh_of(const std::string& file, double scale, const std::array<double, 3>& shift) {
  ShownMesh mesh{std::filesystem::path(file).filename().string(), read_stl(file)};
  for (auto& triangle : mesh.triangles)
    for (Vector3& corner : triangle)
      corner = scale * corner + Vector3{shift[0], shift[1], shift[2]};
  return mesh;
}

/// A mesh file as its command names it, seen from here or from the folder of the log; empty where
/// it is at neither place.
std::string present_file(const std::string& name, const std::string& log) {
  for (const auto& folder : {std::filesystem::path(), std::filesystem::path(log).parent_path()})
    if (std::filesystem::is_regular_file(folder / name))
      return (folder / name).string();
  return "";
}

void add_meshes_of_run(const RunWalls& walls, const std::string& log, RunSurfaces& surfaces) {
  const auto leave_out = [](const RunMesh& mesh, const std::string& reason) {
    const std::string words =
        fmt::format("mesh {} ({}) is not shown: {}; give it as it is in space by --mesh", mesh.id,
                    mesh.file, reason);
    report_warning(words, words);
  };
  for (const RunMesh& mesh : walls.meshes) {
    const std::string file = present_file(mesh.file, log);
    if (mesh.is_turned)
      leave_out(mesh, "its command turns it");
    else if (mesh.moves)
      leave_out(mesh, "it moves");
    else if (file.empty() || std::filesystem::path(file).extension() != ".stl")
      leave_out(mesh, "there is no STL file of this name");
    else
      surfaces.meshes.push_back(mesh_of(file, mesh.scale, mesh.shift));
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
    surfaces.meshes.push_back(mesh_of(mesh, 1.0, {}));
  const std::string log = options.log.empty() ? log_beside(dump) : options.log;
  if (without_log || log.empty())
    return surfaces;
  const RunWalls walls = read_run_walls(log);
  surfaces.planes = walls.planes;
  if (options.meshes.empty())
    add_meshes_of_run(walls, log, surfaces);
  return surfaces;
}

} // namespace ellipsoid::post
