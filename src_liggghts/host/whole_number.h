// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace ellipsoid_host {

/// The number that a token is as a whole; nothing where it is more, less or out of range. (The
/// host's atof and atoi take what the token begins with, and 0 for what is no number.)
inline std::optional<double> whole_number(const char* token) {
  char* end = nullptr;
  const double value = std::strtod(token, &end);
  if (end == token || *end != '\0' || !std::isfinite(value))
    return {};
  return value;
}

/// The same for integers.
inline std::optional<long> whole_integer(const char* token) {
  char* end = nullptr;
  errno = 0;
  const long value = std::strtol(token, &end, 10);
  if (end == token || *end != '\0' || errno != 0)
    return {};
  return value;
}

/// @param[in] number >= 0
inline bool is_prime(long number) {
  for (long divisor = 2; divisor * divisor <= number; ++divisor)
    if (number % divisor == 0)
      return false;
  return number > 1;
}

} // namespace ellipsoid_host
