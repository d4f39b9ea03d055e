// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>

namespace ellipsoid::post {

/// What is being computed, on standard error if that is a terminal; takes the place of the last
/// one.
void show_progress_line(const std::string& text);
/// Takes the line away.
void clear_progress_line();

} // namespace ellipsoid::post
