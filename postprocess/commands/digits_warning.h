// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"

namespace ellipsoid::post {

/// Warns on standard error when a file's digits are too few for contacts (the host's default format
/// %g keeps six).
void warn_of_digits(const ChosenFrame& chosen);

} // namespace ellipsoid::post
