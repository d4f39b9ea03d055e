// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "space_wall_options.h"

#include "input_error.h"
#include "run_walls.h"
#include "stl_mesh.h"

#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

void require_multiple(const std::vector<double>& numbers, std::size_t each,
                      const std::string& option) {
  if (numbers.size() % each != 0)
    throw InputError(fmt::format("{} needs {} numbers for each wall, found {} altogether", option,
                                 each, numbers.size()));
}

Vector3 vector_at(const std::vector<double>& numbers, std::size_t k) {
  return {numbers[k], numbers[k + 1], numbers[k + 2]};
}

Vector3 unit_at(const std::vector<double>& numbers, std::size_t k, const std::string& option) {
  const Vector3 v = vector_at(numbers, k);
  if (!(norm(v) > 0.0))
    throw InputError(option + ": the direction has length 0");
  return normalized(v);
}

void append_box(std::vector<SpaceWall>& walls, const double* b) {
  if (!(b[0] < b[1] && b[2] < b[3] && b[4] < b[5]))
    throw InputError("--box-wall needs x0 < x1, y0 < y1 and z0 < z1");
  const Vector3 lower{b[0], b[2], b[4]}, upper{b[1], b[3], b[5]};
  for (const Vector3& axis : {Vector3{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}) {
    walls.push_back(PlaneWall{lower, axis});
    walls.push_back(PlaneWall{upper, -axis});
  }
}

} // namespace

void add_space_wall_options(CLI::App& command, SpaceWallOptions& options) {
  command.add_option("--plane-wall", options.planes,
                     "x y z of a point and the normal nx ny nz towards the particles, and more "
                     "walls");
  command.add_option(
      "--cylinder-wall", options.cylinders,
      "x y z of a point of the axis, its direction ux uy uz, radius, and more walls");
  command.add_option("--box-wall", options.boxes,
                     "x0 x1 y0 y1 z0 z1: six walls around the particles");
  CLI::Option* meshes =
      command.add_option("--mesh-wall", options.meshes, "STL files, a wall each, where they lie");
  command.add_option("--mesh-scale", options.mesh_scale, "factor on the lengths of the STL files")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->needs(meshes);
}

std::vector<SpaceWall> space_walls(const SpaceWallOptions& options) {
  constexpr std::size_t of_plane = 6, of_cylinder = 7, of_box = 6;
  require_multiple(options.planes, of_plane, "--plane-wall");
  require_multiple(options.cylinders, of_cylinder, "--cylinder-wall");
  require_multiple(options.boxes, of_box, "--box-wall");
  std::vector<SpaceWall> walls;
  for (std::size_t k = 0; k < options.planes.size(); k += of_plane)
    walls.push_back(
        PlaneWall{vector_at(options.planes, k), unit_at(options.planes, k + 3, "--plane-wall")});
  for (std::size_t k = 0; k < options.cylinders.size(); k += of_cylinder) {
    if (!(options.cylinders[k + 6] > 0.0))
      throw InputError("--cylinder-wall needs a radius > 0");
    walls.push_back(CylinderWall{vector_at(options.cylinders, k),
                                 unit_at(options.cylinders, k + 3, "--cylinder-wall"),
                                 options.cylinders[k + 6]});
  }
  for (std::size_t k = 0; k < options.boxes.size(); k += of_box)
    append_box(walls, options.boxes.data() + k);
  for (const std::string& file : options.meshes) {
    MeshWall wall{read_stl(file)};
    for (auto& triangle : wall.triangles)
      for (Vector3& corner : triangle)
        corner *= options.mesh_scale;
    walls.push_back(std::move(wall));
  }
  return walls;
}

std::vector<SpaceWall> walls_of_log(const std::string& log) {
  const RunWalls named = read_run_walls(log);
  const auto unit = [](unsigned axis) {
    return Vector3{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
  };
  std::vector<SpaceWall> walls;
  for (const PrimitivePlane& plane : named.planes)
    walls.push_back(SheetWall{plane.position * unit(plane.axis), unit(plane.axis)});
  for (const PrimitiveCylinder& c : named.cylinders)
    walls.push_back(
        CylinderWall{c.middle[0] * unit((c.axis + 1) % 3) + c.middle[1] * unit((c.axis + 2) % 3),
                     unit(c.axis), c.radius});
  for (const RunMesh& mesh : named.meshes)
    walls.push_back(MeshWall{triangles_of(mesh, log)});
  if (walls.empty())
    throw InputError(log +
                     ": expected walls (fix wall/gran... with a plane, a cylinder or meshes), "
                     "found none");
  return walls;
}

} // namespace ellipsoid::post
