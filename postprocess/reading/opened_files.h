// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>

namespace ellipsoid::post {

/// Whether this program has read from the file of this name (under any name), so that a result must
/// not be written over it. From any thread.
bool has_been_read(const std::string& path);

} // namespace ellipsoid::post
