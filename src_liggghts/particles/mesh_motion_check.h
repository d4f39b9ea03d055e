// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>
#include <vector>

namespace ellipsoid_host {

/// What the host does not see in the arguments of a `fix move/mesh`: a vibration of fewer periods
/// than terms, a period or an axis of 0.
/// @param[in] words of the command from the ID on
/// @return the complaint with its remedy, or an empty string
std::string wrong_mesh_motion(const std::vector<std::string>& words);

} // namespace ellipsoid_host
