// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// A plane wall of a run: all points whose coordinate `axis` is `place`.
struct PrimitivePlane {
  unsigned axis = 0;
  double place = 0.0; ///< (length)
};

/// A surface mesh of a run and how its command changed the file's coordinates.
struct RunMesh {
  std::string id, file; ///< as the command names them
  double scale = 1.0;
  std::array<double, 3> shift{}; ///< after scaling (length)
  bool is_turned = false;        ///< by `rotate`: the file does not show where the mesh is
  bool moves = false;            ///< by a fix move/mesh
};

struct RunWalls {
  std::vector<PrimitivePlane> planes;
  std::vector<RunMesh> meshes;
};

/// The walls that the commands of a LIGGGHTS log name: `fix ... wall/gran... primitive ...
/// xplane|yplane|zplane P` and `fix ID mesh/surface... file NAME`; those taken back by `unfix` left
/// out. Throws InputError when the log cannot be read.
RunWalls read_run_walls(const std::string& log);

} // namespace ellipsoid::post
