// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Keys of tables have their unit as the last part: "density_kg_per_m3".
#pragma once

#include <string>

namespace ellipsoid::post {

struct KeyParts {
  std::string name; ///< "density"
  std::string unit; ///< as in the key, "kg_per_m3"; empty: none
};

/// What a key measures, and its unit.
KeyParts parts_of_key(const std::string& key);

/// "kg_per_m2_s" as one writes it: "kg/m2/s".
std::string unit_in_words(const std::string& unit);

} // namespace ellipsoid::post
