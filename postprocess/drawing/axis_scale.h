// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <vector>

namespace ellipsoid::post {

/// 1, 2 or 5 times a power of ten, the largest that is <= length.
double round_length(double length);

/// Round numbers within [low, high], about `wanted` of them.
std::vector<double> round_ticks(double low, double high, int wanted);

} // namespace ellipsoid::post
