// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

namespace ellipsoid::post {

/// 1 - solid / total. Throws InputError for a value outside 0 to 1: no such porosity exists.
/// @param[in] solid, total areas or volumes, total > 0
double porosity_of(double solid, double total);

} // namespace ellipsoid::post
