// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame.h"

#include <string>

namespace ellipsoid::post {

/// Throws InputError where several columns have this name: which one is meant is not known.
void require_once(const Frame& frame, const std::string& name);

} // namespace ellipsoid::post
