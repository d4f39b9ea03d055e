// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "mesh_motion_check.h"

#include "whole_number.h"

#include <algorithm>
#include <cstddef>

namespace ellipsoid_host {

namespace {

using Words = std::vector<std::string>;

/// The words behind a keyword up to the next word that is no number.
Words values_of(const Words& words, const std::string& keyword) {
  auto from = std::find(words.begin(), words.end(), keyword);
  Words values;
  if (from != words.end())
    for (++from; from != words.end() && whole_number(from->c_str()); ++from)
      values.push_back(*from);
  return values;
}

bool is_zero(const std::string& number) { return whole_number(number.c_str()) == 0.0; }

} // namespace

std::string wrong_mesh_motion(const Words& words) {
  constexpr std::size_t motion = 5; // ID group move/mesh mesh MESH_ID MOTION
  if (words.size() <= motion)
    return {};
  const Words periods = values_of(words, "period"), axis = values_of(words, "axis");
  const Words order = values_of(words, "order");
  const bool vibrates = words[motion] == "viblin" || words[motion] == "vibrot";
  if (vibrates && order.size() == 1)
    if (const auto terms = whole_integer(order[0].c_str()); terms && *terms > 0)
      for (const char* keyword : {"amplitude", "phase", "period"})
        if (const auto given = values_of(words, keyword).size();
            given != static_cast<std::size_t>(*terms))
          return "keyword '" + std::string(keyword) + "' has " + std::to_string(given) +
                 " numbers, 'order' allows " + order[0] + ": give one for each term";
  if (std::any_of(periods.begin(), periods.end(), is_zero))
    return "keyword 'period' has the value 0; give the time of a turn or of a vibration";
  if (axis.size() == 3 && std::all_of(axis.begin(), axis.end(), is_zero))
    return "keyword 'axis' has the values 0 0 0; give a direction";
  return {};
}

} // namespace ellipsoid_host
