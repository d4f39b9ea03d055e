// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "key_units.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace ellipsoid::post {
namespace {

bool is_unit(const std::string& part) {
  constexpr std::string_view units[] = {"m", "m2", "m3",  "m5",  "s",    "s2", "kg",     "N",
                                        "J", "Pa", "deg", "rad", "rad2", "b",  "percent"};
  return std::find(std::begin(units), std::end(units), part) != std::end(units);
}

std::vector<std::string> split(const std::string& key) {
  std::vector<std::string> parts(1);
  for (const char letter : key)
    if (letter == '_')
      parts.emplace_back();
    else
      parts.back() += letter;
  return parts;
}

std::string joined(const std::vector<std::string>& parts, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t k = begin; k < end; ++k)
    text += (k > begin ? "_" : "") + parts[k];
  return text;
}

/// Where the unit begins: a unit, or units behind "per" with at most one before it.
std::size_t begin_of_unit(const std::vector<std::string>& parts) {
  std::size_t begin = parts.size();
  while (begin > 1 && is_unit(parts[begin - 1]))
    --begin;
  if (begin == parts.size())
    return begin;
  if (begin > 1 && parts[begin - 1] == "per") {
    --begin;
    return begin > 1 && is_unit(parts[begin - 1]) ? begin - 1 : begin;
  }
  return parts.size() - 1;
}

} // namespace

KeyParts parts_of_key(const std::string& key) {
  const std::vector<std::string> parts = split(key);
  const std::size_t begin = begin_of_unit(parts);
  return {joined(parts, 0, begin), joined(parts, begin, parts.size())};
}

std::string unit_in_words(const std::string& unit) {
  if (unit == "percent")
    return "%";
  std::string text;
  bool is_below = false;
  for (const std::string& part : split(unit)) {
    if (part == "per") {
      text += text.empty() ? "1" : "";
      is_below = true;
    } else {
      text += (is_below ? "/" : "") + part;
    }
  }
  return text;
}

} // namespace ellipsoid::post
