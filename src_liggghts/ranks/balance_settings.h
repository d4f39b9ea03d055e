// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What fix and command balance/ellipsoid have in common: their keywords, and with what they work.
#pragma once

#include "ellipsoid_host.h"
#include "sub_domains.h"

#include <string>

namespace ellipsoid_host {

/// Reads the value of 'directions' or 'width'; false if the keyword is another one.
bool read_balance_setting(ArgumentReader& reader, const std::string& keyword,
                          BalanceSettings& settings);
/// These keywords in messages.
extern const char* const balance_keywords;

/// Stops with one line where planes cannot be shifted: bodies that the host hands from rank to rank
/// by itself, boxes that are wedges.
void check_shifts_are_possible(LAMMPS_NS::LAMMPS* lmp, const std::string& command);

} // namespace ellipsoid_host
