// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "table.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// The rows of CSV files (comma, first line the keys, fields may be quoted), one file after the
/// other: whole-token numbers become numbers, empty fields, nan and inf are missing, all else is
/// text.
/// @param[in] number_columns columns that hold numbers or nothing
/// Throws InputError for a missing file, an empty header, a name that several columns have, a row
/// with another number of fields, a word in a column of numbers.
Table read_csv_files(const std::vector<std::string>& paths,
                     const std::vector<std::string>& number_columns);

/// The keys of a table as text: "found only: a, b, c".
std::string columns_found(const Table& table);

/// "2 of 5 runs have no number in "zpp" (a, b)"; empty where all have.
std::string runs_without_number(const Table& runs, const std::string& key);

/// A value as a number, or nothing.
bool as_number(const Value& value, double& number);

} // namespace ellipsoid::post
