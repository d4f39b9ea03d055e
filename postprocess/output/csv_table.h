// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "table.h"

namespace ellipsoid::post {

/// Reads a CSV file (comma, first line the keys, fields may be quoted) as a table: whole-token
/// numbers become numbers, empty fields are missing, all else is text.
/// Throws InputError for a missing file, an empty header, a row with another number of fields.
Table read_csv(const std::string& path);

/// A value as a number, or nothing.
bool as_number(const Value& value, double& number);

} // namespace ellipsoid::post
