// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "math/vector3.h"

#include <array>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Corners of the triangles of an STL file, text or binary, in the unit of the file.
/// Throws InputError when it cannot be read, is cut off, or has a coordinate that is no number.
std::vector<std::array<Vector3, 3>> read_stl(const std::string& path);

} // namespace ellipsoid::post
