// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>

namespace ellipsoid::post {

/// Compares names, runs of digits as numbers: seed2 before seed10.
bool natural_less(const std::string& a, const std::string& b);

} // namespace ellipsoid::post
