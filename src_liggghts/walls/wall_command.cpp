// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall_command.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "ellipsoid_models.h"
#include "fix.h"
#include "model_names.h"
#include "modify.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace ellipsoid_host {

namespace {

constexpr int first_argument = 3; // behind ID, group and style

WallCylinder check_primitive(LAMMPS_NS::LAMMPS* lmp, ArgumentReader& reader) {
  reader.choice("primitive", {"type"});
  reader.integer("type", 1, lmp->atom->ntypes);
  const std::vector<std::string> shapes{"xplane",    "yplane",    "zplane",
                                        "xcylinder", "ycylinder", "zcylinder"};
  const int shape = reader.choice("primitive type T", shapes);
  const std::string& name = shapes[static_cast<std::size_t>(shape)];
  WallCylinder cylinder;
  if (shape < 3) {
    reader.number(name, -HUGE_VAL, HUGE_VAL);
    return cylinder;
  }
  cylinder.axis = shape - 3;
  cylinder.radius = reader.positive(name);
  for (const int k : {1, 2}) // the host's order: y z, z x, x y
    cylinder.centre[(cylinder.axis + k) % 3] = reader.number(name, -HUGE_VAL, HUGE_VAL);
  return cylinder;
}

void check_meshes(LAMMPS_NS::LAMMPS* lmp, ArgumentReader& reader, int count) {
  for (int k = 0; k < count; ++k) {
    const std::string mesh = reader.word("meshes");
    const int fix = lmp->modify->find_fix(mesh.c_str());
    if (fix < 0 || std::strncmp(lmp->modify->fix[fix]->style, "mesh/surface", 12) != 0)
      reader.complain("keyword 'meshes' has the value '" + mesh +
                      "', allowed are ids of fix mesh/surface; define the mesh before the wall");
  }
}

/// What is wrong with one of the models, or an empty string; of unknown ones the host speaks.
std::string wrong_model(LAMMPS_NS::LAMMPS* lmp, int count, char** words) {
  const LIGGGHTS::ContactModels::NamedModels names(count, words);
  const bool all_known = select_models(count, words, lmp, lmp->force) != -1;
  return all_known ? unsuitable_model(names) : std::string();
}

} // namespace

WallCylinder check_wall_command(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) {
  ArgumentReader reader(lmp->error, "wall/gran/ellipsoid", arg[0], narg, arg, first_argument);
  constexpr int most_meshes = 1000;
  int meshes = 0;
  bool has_mesh = false, lists_meshes = false;
  WallCylinder cylinder;
  while (!reader.done()) {
    const std::string keyword = reader.keyword();
    has_mesh = has_mesh || keyword == "mesh";
    lists_meshes = lists_meshes || keyword == "meshes";
    if (keyword == "primitive")
      cylinder = check_primitive(lmp, reader);
    else if (keyword == "n_meshes")
      meshes = reader.integer("n_meshes", 1, most_meshes);
    else if (keyword == "meshes")
      check_meshes(lmp, reader, meshes);
  }
  if (has_mesh && !lists_meshes)
    reader.complain("'mesh' names no meshes; add 'n_meshes N meshes ID1 ... IDN'");
  const std::string complaint = wrong_model(lmp, narg - first_argument, arg + first_argument);
  if (!complaint.empty())
    reader.complain(complaint);
  return cylinder;
}

std::string wall_law(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, int settings) {
  int behind_models = narg - first_argument;
  char** words = arg + first_argument;
  select_models(behind_models, words, lmp, lmp->force);
  std::string law;
  for (int k = first_argument; k < narg; ++k)
    if (k < narg - behind_models || k >= settings)
      law += (law.empty() ? "" : " ") + std::string(arg[k]);
  return law;
}

std::string wall_kind(int narg, char** arg) {
  const std::vector<std::string> words(arg + first_argument, arg + narg);
  const auto word = std::find(words.begin(), words.end(), "primitive");
  if (words.end() - word > 3) // primitive type T SHAPE
    return *(word + 3);
  const auto count = std::find(words.begin(), words.end(), "n_meshes"),
             meshes = std::find(words.begin(), words.end(), "meshes");
  if (words.end() - count < 2 || meshes == words.end())
    return {};
  const auto first = meshes + 1;
  const auto number = std::min<std::ptrdiff_t>(std::stoi(*(count + 1)), words.end() - first);
  std::string kind = "meshes";
  for (auto mesh = first; mesh != first + number; ++mesh)
    kind += " " + *mesh;
  return kind;
}

} // namespace ellipsoid_host
