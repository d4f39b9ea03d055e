// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The models and settings among the arguments of fix wall/gran/ellipsoid: what the history of its
// contacts depends on, apart from where the wall is, how it moves and how hot it is.
#pragma once

#include <string>
#include <vector>

namespace ellipsoid_host {

/// @param[in] words all arguments behind the style, already checked
std::string wall_law(const std::vector<std::string>& words);

} // namespace ellipsoid_host
