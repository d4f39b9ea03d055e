// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <cstdint>
#include <string>

namespace ellipsoid::post {

/// The name of a frame's file: an asterisk becomes the time step, with ten digits. To be called
/// once for each file, from any thread.
/// Throws InputError for a name that has been given already: nothing is overwritten.
std::string name_with_step(const std::string& pattern, std::int64_t timestep);

} // namespace ellipsoid::post
