// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "math/vector3.h"

#include <array>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// A plane wall of a run: all points whose coordinate `axis` is `position`.
struct PrimitivePlane {
  unsigned axis = 0;
  double position = 0.0; ///< (length)
};

/// A cylinder wall of a run about an axis along x, y or z, of infinite length.
struct PrimitiveCylinder {
  unsigned axis = 0;
  double radius = 0.0;            ///< (length)
  std::array<double, 2> middle{}; ///< coordinates along the two axes that follow (z: x y, y: z x)
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
  std::vector<PrimitiveCylinder> cylinders;
  std::vector<RunMesh> meshes;
};

/// The walls that the commands of a LIGGGHTS log name: `fix ... wall/gran... primitive ...
/// xplane|yplane|zplane P` or `xcylinder|ycylinder|zcylinder R C1 C2`, and `fix ID mesh/surface...
/// file NAME`; those taken back by `unfix` left out. Throws InputError when the log cannot be read.
RunWalls read_run_walls(const std::string& log);

/// Why the triangles of a run's mesh are not known from its file; empty where they are.
/// @param[in] log of the run: files are looked for from here and from its folder
std::string why_unknown(const RunMesh& mesh, const std::string& log);

/// The triangles of a run's mesh as they lie in space (length). Throws InputError where they are
/// not known.
std::vector<std::array<Vector3, 3>> triangles_of(const RunMesh& mesh, const std::string& log);

} // namespace ellipsoid::post
