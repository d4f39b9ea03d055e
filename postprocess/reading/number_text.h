// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string_view>

namespace ellipsoid::post {

/// Reads the number at the beginning of a text, correctly rounded.
/// @param[in] text ends at `end`; *end must be readable and be no part of a number (a line's end)
/// @param[out] value finite; too small a number is 0
/// @return behind the number; nullptr where no finite number stands, or where something other
///         than a blank, a tab or the end follows it
const char* read_number(const char* text, const char* end, double& value);

} // namespace ellipsoid::post
