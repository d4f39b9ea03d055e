// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "run_walls.h"

#include "byte_source.h"
#include "stl_mesh.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <sstream>

namespace ellipsoid::post {
namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& line) {
  std::istringstream text(line.substr(0, line.find('#')));
  Words words;
  for (std::string word; text >> word;)
    words.push_back(word);
  return words;
}

/// The words after a keyword, as numbers; empty if it or one of them is not there.
std::vector<double> numbers_after(const Words& words, const std::string& keyword, unsigned count) {
  const auto found = std::find(words.begin(), words.end(), keyword);
  std::vector<double> numbers;
  if (found == words.end() || words.end() - found <= static_cast<std::ptrdiff_t>(count))
    return numbers;
  for (unsigned k = 1; k <= count; ++k) {
    std::istringstream text(*(found + k));
    double value = 0.0;
    if (!(text >> value) || !text.eof())
      return {};
    numbers.push_back(value);
  }
  return numbers;
}

struct Found {
  std::map<std::string, PrimitivePlane> planes; ///< by the fix's id
  std::map<std::string, PrimitiveCylinder> cylinders;
  std::map<std::string, RunMesh> meshes;
};

void read_mesh(const Words& words, Found& found) {
  RunMesh mesh;
  mesh.id = words[1];
  const auto file = std::find(words.begin(), words.end(), "file");
  if (file == words.end() || file + 1 == words.end())
    return;
  mesh.file = *(file + 1);
  if (const auto scale = numbers_after(words, "scale", 1); !scale.empty())
    mesh.scale = scale[0];
  if (const auto move = numbers_after(words, "move", 3); !move.empty())
    mesh.shift = {move[0], move[1], move[2]};
  mesh.is_turned = std::find(words.begin(), words.end(), "rotate") != words.end();
  found.meshes[mesh.id] = mesh;
}

/// A mesh file as its command names it, seen from here or from the folder of the log; empty where
/// it is at neither place.
std::string present_file(const std::string& name, const std::string& log) {
  for (const auto& folder : {std::filesystem::path(), std::filesystem::path(log).parent_path()})
    if (std::filesystem::is_regular_file(folder / name))
      return (folder / name).string();
  return "";
}

void read_command(const Words& words, Found& found) {
  if (words.size() == 2 && words[0] == "unfix") {
    found.planes.erase(words[1]);
    found.cylinders.erase(words[1]);
    found.meshes.erase(words[1]);
  }
  if (words.size() < 5 || words[0] != "fix")
    return;
  if (words[3].rfind("mesh/surface", 0) == 0)
    read_mesh(words, found);
  if (words[3].rfind("move/mesh", 0) == 0)
    if (const auto mesh = std::find(words.begin(), words.end(), "mesh"); words.end() - mesh > 1)
      if (const auto moved = found.meshes.find(*(mesh + 1)); moved != found.meshes.end())
        moved->second.moves = true;
  if (words[3].rfind("wall/gran", 0) == 0)
    for (const unsigned axis : {0u, 1u, 2u}) {
      const std::string letter(1, "xyz"[axis]);
      if (const auto position = numbers_after(words, letter + "plane", 1); !position.empty())
        found.planes[words[1]] = {axis, position[0]};
      if (const auto c = numbers_after(words, letter + "cylinder", 3); !c.empty())
        found.cylinders[words[1]] = {axis, c[0], {c[1], c[2]}};
    }
}

} // namespace

RunWalls read_run_walls(const std::string& log) {
  LineReader lines(open_bytes(log), log);
  std::string_view view;
  std::string command;
  Found found;
  while (lines.next(view)) {
    command += std::string(view);
    const auto last = command.find_last_not_of(" \t\r");
    if (last != std::string::npos && command[last] == '&') { // goes on in the next line
      command.resize(last);
      command += ' ';
      continue;
    }
    if (command.find('$') == std::string::npos) // with variables: echoed again with their values
      read_command(words_of(command), found);
    command.clear();
  }
  RunWalls walls;
  for (const auto& [id, plane] : found.planes)
    walls.planes.push_back(plane);
  for (const auto& [id, cylinder] : found.cylinders)
    walls.cylinders.push_back(cylinder);
  for (const auto& [id, mesh] : found.meshes)
    walls.meshes.push_back(mesh);
  return walls;
}

std::string why_unknown(const RunMesh& mesh, const std::string& log) {
  const std::string file = present_file(mesh.file, log);
  if (mesh.is_turned)
    return "its command turns it";
  if (mesh.moves)
    return "it moves";
  return file.empty() || std::filesystem::path(file).extension() != ".stl"
             ? "there is no STL file of this name"
             : "";
}

std::vector<std::array<Vector3, 3>> triangles_of(const RunMesh& mesh, const std::string& log) {
  if (const std::string reason = why_unknown(mesh, log); !reason.empty())
    throw InputError(fmt::format("mesh {} ({}) of {}: {}", mesh.id, mesh.file, log, reason));
  auto triangles = read_stl(present_file(mesh.file, log));
  for (auto& triangle : triangles)
    for (Vector3& corner : triangle)
      corner = mesh.scale * corner + Vector3{mesh.shift[0], mesh.shift[1], mesh.shift[2]};
  return triangles;
}

} // namespace ellipsoid::post
