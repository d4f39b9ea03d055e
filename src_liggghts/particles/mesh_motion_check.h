// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>
#include <vector>

namespace ellipsoid_host {

/// What the host accepts in the arguments of a `fix move/mesh` and is wrong: amplitudes, phases or
/// periods of a vibration that are not as many as `order` says, a period or an axis of 0.
/// @param[in] words of the command from the ID on
/// @return the complaint with its remedy, or an empty string
std::string wrong_mesh_motion(const std::vector<std::string>& words);

} // namespace ellipsoid_host
