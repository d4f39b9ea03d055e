// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which styles of the host do not work with ellipsoids, why, and what to use
// (doc/what_works_with_what.md lists them beside those that work).
#pragma once

#include <string>

namespace ellipsoid_host {

/// Why the style cannot be used with atom_style granular/ellipsoid and what to use, or an empty
/// string where it can.
/// @param[in] kind "fix", "compute", "pair_style", "dump", "run_style" or "command"
/// @param[in] style as in an input script
std::string why_unsuited(const std::string& kind, const std::string& style);

} // namespace ellipsoid_host
