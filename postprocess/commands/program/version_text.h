// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>

namespace ellipsoid::post {

/// The versions of this package, of the compiler and of the libraries that may be left out.
std::string version_text();

} // namespace ellipsoid::post
