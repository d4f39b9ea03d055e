// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>

namespace ellipsoid::post {

/// Legacy VTK files have no end mark, and VTK's reader leaves values that are not there undefined:
/// looks whether a file (.vtk, text or binary, PolyData or unstructured grid, as the host and VTK
/// write them) holds all that it announces, and ends with a line's end. Throws InputError.
void check_legacy_vtk(const std::string& path);

} // namespace ellipsoid::post
