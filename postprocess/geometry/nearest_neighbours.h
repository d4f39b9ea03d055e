// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "periodic_cell.h"

#include <vector>

namespace ellipsoid::post {

/// The nearest other points of each point, images in a periodic cell included: `count` indices for
/// each, nearest first.
/// Throws InputError when there are not more points than that.
std::vector<std::vector<std::size_t>>
nearest_neighbours(const std::vector<Vector3>& points, const PeriodicCell& cell, std::size_t count);

} // namespace ellipsoid::post
