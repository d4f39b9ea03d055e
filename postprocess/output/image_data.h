// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "math/vector3.h"

#include <array>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Values at the points of a regular grid.
struct GridValues {
  std::string name;
  int components = 1;
  std::vector<double> values; ///< point by point, x fastest, the components side by side
};

struct ImageData {
  Vector3 origin, spacing; ///< (length)
  std::array<int, 3> counts{};
  std::vector<GridValues> values;
};

/// VTK XML ImageData, compressed, for little-endian machines.
std::string vti_text(const ImageData& image);

} // namespace ellipsoid::post
