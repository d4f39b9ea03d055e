// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "csv_table.h"

#include "byte_source.h"
#include "input_error.h"
#include "whole_token.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace ellipsoid::post {
namespace {

/// Which of two columns of one name is meant is not known; columns without a name mean nothing.
void require_names_once(const std::vector<std::string>& keys, const std::string& path) {
  for (auto key = keys.begin(); key != keys.end(); ++key)
    if (!key->empty() && std::find(std::next(key), keys.end(), *key) != keys.end())
      throw InputError(fmt::format("{}:1: expected one column \"{}\", found several: give each a "
                                   "name of its own in this line",
                                   path, *key));
}

/// Fields of one line; a doubled quote inside quotes stands for one.
std::vector<std::string> fields_of(std::string_view line, const FileLocation& location) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char letter = line[k];
    if (letter == '"' && is_quoted && k + 1 < line.size() && line[k + 1] == '"') {
      fields.back() += letter;
      ++k;
    } else if (letter == '"') {
      is_quoted = !is_quoted;
    } else if (letter == ',' && !is_quoted) {
      fields.emplace_back();
    } else {
      fields.back() += letter;
    }
  }
  if (is_quoted)
    throw InputError(
        fmt::format("{}:{}: expected a closing quote in this line", location.file, location.line));
  return fields;
}

Value value_of(const std::string& field) {
  if (field.empty())
    return std::monostate();
  if (const auto number = whole_token<double>(field))
    return std::isfinite(*number) ? Value(*number) : Value();
  return field;
}

Table table_of(const std::string& path, const std::vector<std::string>& number_columns) {
  LineReader lines(open_bytes(path), path);
  std::string_view line;
  if (!lines.next(line) || line.empty())
    throw InputError(fmt::format("{}:1: expected a line with the names of the columns", path));
  const auto keys = fields_of(line, {path, 1, 0});
  require_names_once(keys, path);
  Table table;
  while (lines.next(line)) {
    if (line.empty())
      continue;
    const auto fields = fields_of(line, {path, lines.line_number(), 0});
    if (fields.size() != keys.size())
      throw InputError(fmt::format("{}:{}: expected {} fields, found {}", path, lines.line_number(),
                                   keys.size(), fields.size()));
    Row row;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      row.push_back({keys[k], keys[k], "", value_of(fields[k])});
      if (std::holds_alternative<std::string>(row.back().value) &&
          std::find(number_columns.begin(), number_columns.end(), keys[k]) != number_columns.end())
        throw unexpected({path, lines.line_number(), 0},
                         fmt::format("a number in column \"{}\"", keys[k]), quoted(fields[k]));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

} // namespace

Table read_csv_files(const std::vector<std::string>& paths,
                     const std::vector<std::string>& number_columns) {
  Table all;
  for (const std::string& path : paths) {
    Table table = table_of(path, number_columns);
    std::move(table.rows.begin(), table.rows.end(), std::back_inserter(all.rows));
  }
  return all;
}

std::string columns_found(const Table& table) {
  std::string text;
  for (const Quantity& q : table.header())
    text += (text.empty() ? "found only: " : ", ") + q.key;
  return text.empty() ? "found no rows" : text;
}

std::string runs_without_number(const Table& runs, const std::string& key) {
  std::string names;
  std::size_t count = 0;
  for (std::size_t k = 0; k < runs.rows.size(); ++k) {
    const Value* value = find_value(runs.rows[k], key);
    if (double number = 0.0; value && as_number(*value, number))
      continue;
    const Value* run = find_value(runs.rows[k], "run");
    names += (count++ > 0 ? ", " : "") + (run ? shown(*run) : fmt::format("row {}", k + 1));
  }
  return count == 0 ? ""
                    : fmt::format("{} of {} runs {} no number in \"{}\" ({})", count,
                                  runs.rows.size(), count == 1 ? "has" : "have", key, names);
}

bool as_number(const Value& value, double& number) {
  if (const auto* real = std::get_if<double>(&value))
    number = *real;
  else if (const auto* integer = std::get_if<std::int64_t>(&value))
    number = static_cast<double>(*integer);
  else
    return false;
  return true;
}

} // namespace ellipsoid::post
