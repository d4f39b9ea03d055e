// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Results as a table: for people, as CSV, as JSON. Units stand in the names.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ellipsoid::post {

using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

/// One named result. Keys have the unit as their last part: "repose_angle_deg".
struct Quantity {
  std::string key;  ///< for CSV and JSON
  std::string name; ///< for people: "angle of repose"
  std::string unit; ///< for people: "deg"; may be empty
  Value value;
};

using Row = std::vector<Quantity>;

struct Table {
  std::string title;
  std::vector<Row> rows;
  Row columns = {}; ///< of a table that may rightly have no rows: its header then

  /// Keys of all rows in the order of their first appearance.
  std::vector<Quantity> header() const;
};

/// One row: a line per quantity. Several rows: a column per quantity; a run that is the same in
/// all of them stands in the title.
std::string as_text(const Table& table);
/// First line the keys; numbers with all digits; missing values empty.
std::string as_csv(const Table& table);
/// An array of objects.
std::string as_json(const Table& table);

/// Writes text to a file, or to standard output for "-". Throws InputError when it cannot.
void write_text(const std::string& path, const std::string& text);

/// A value for people: five digits; "-" where it is missing.
std::string shown(const Value& value);

/// The value of a row by its key, or nothing.
const Value* find_value(const Row& row, const std::string& key);

} // namespace ellipsoid::post
