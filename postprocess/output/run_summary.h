// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "table.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// One row per group: the group's keys, the number of runs, and for each quantity mean, half
/// range, half range in percent of the mean, standard deviation, lowest and highest value.
/// Rows without one of the group's keys form a group of their own ("-"). Groups are in the order
/// of their keys, numbers as numbers.
/// @param[in] quantities keys; those that no row has as a number are left out
Table summary_of(const Table& runs, const std::vector<std::string>& group_keys,
                 const std::vector<std::string>& quantities);

/// The same for people, a cell for each quantity: "22.7 +- 1.8 (8 %)", or "22.7 (one run)".
Table summary_for_people(const Table& runs, const std::vector<std::string>& group_keys,
                         const std::vector<std::string>& quantities);

} // namespace ellipsoid::post
