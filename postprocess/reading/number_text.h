// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string_view>

namespace ellipsoid::post {

/// read_number() for any number.
const char* read_longer_number(const char* text, const char* end, double& value);

/// Reads the number at the beginning of a text, correctly rounded.
/// @param[in] text ends at `end`; *end must be readable and be no part of a number (a line's end)
/// @param[out] value finite; too small a number is 0
/// @return behind the number; nullptr where no finite number stands, or where something other
///         than a blank, a tab or the end follows it
inline const char* read_number(const char* text, const char* end, double& value) {
  const char letter = *text; // a single digit is what is written most often
  if (letter < '0' || letter > '9' || text[1] != ' ')
    return read_longer_number(text, end, value);
  value = letter - '0';
  return text + 1;
}

} // namespace ellipsoid::post
