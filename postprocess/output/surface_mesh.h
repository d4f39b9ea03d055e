// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Triangle surfaces and their files; no library needed.
#pragma once

#include "math/vector3.h"

#include <array>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Values of one quantity at the triangles' particles, for colours in ParaView.
struct CellValues {
  std::string name;
  std::vector<double> values; ///< one per triangle
};

struct SurfaceMesh {
  std::vector<Vector3> points;                       ///< (length)
  std::vector<std::array<std::size_t, 3>> triangles; ///< counter-clockwise from outside
  std::vector<CellValues> cell_values;
};

/// VTK XML PolyData, compressed, for little-endian machines.
std::string vtp_text(const SurfaceMesh& mesh);
/// STL, ASCII.
std::string stl_text(const SurfaceMesh& mesh);

} // namespace ellipsoid::post
