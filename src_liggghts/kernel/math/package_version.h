// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The version of this package: here, and nowhere else.
#pragma once

#include <string>

namespace ellipsoid {

inline constexpr char package_version[] = "1.0.0";

/// The compiler that compiles the including file, "g++ 12.2.0".
inline std::string compiler_name() {
#if defined(__clang__)
  return "clang++ " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown compiler";
#endif
}

} // namespace ellipsoid
