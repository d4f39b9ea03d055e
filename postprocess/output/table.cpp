// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "table.h"

#include "input_error.h"
#include "opened_files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ellipsoid::post {
namespace {

template <class... Functions> struct Overloaded : Functions... { using Functions::operator()...; };
template <class... Functions> Overloaded(Functions...) -> Overloaded<Functions...>;

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

std::string csv_value(const Value& value) {
  return std::visit(Overloaded{[](std::monostate) { return std::string(); },
                               [](bool v) { return std::string(v ? "1" : "0"); },
                               [](std::int64_t v) { return fmt::format("{}", v); },
                               [](double v) { return fmt::format("{}", v); },
                               [](const std::string& v) { return csv_field(v); }},
                    value);
}

nlohmann::ordered_json json_value(const Value& value) {
  return std::visit(Overloaded{[](std::monostate) { return nlohmann::ordered_json(nullptr); },
                               [](const auto& v) { return nlohmann::ordered_json(v); }},
                    value);
}

/// Columns of text with the widest entry's width; the first one to the left.
std::string aligned(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> width;
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) {
      width.resize(std::max(width.size(), line.size()), 0);
      width[k] = std::max(width[k], line[k].size());
    }
  std::string text;
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t k = 0; k < line.size(); ++k)
      row += k == 0 ? fmt::format("{:<{}}", line[k], width[k])
                    : fmt::format("  {:>{}}", line[k], width[k]);
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

std::string vertical(const Row& row) {
  std::size_t name_width = 0, value_width = 0;
  for (const Quantity& q : row) {
    name_width = std::max(name_width, q.name.size());
    if (!q.unit.empty()) // long words without a unit do not push the units away
      value_width = std::max(value_width, shown(q.value).size());
  }
  std::string text;
  for (const Quantity& q : row) {
    std::string line = fmt::format("  {:<{}}  {:<{}}  {}", q.name, name_width, shown(q.value),
                                   value_width, q.unit);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string cell(const Row& row, const Quantity& q) {
  const Value* value = find_value(row, q.key);
  return value ? shown(*value) : "-";
}

/// A line per row of the table.
std::string across(const std::vector<Row>& rows, const std::vector<Quantity>& header) {
  std::vector<std::vector<std::string>> lines(1);
  for (const Quantity& q : header)
    lines[0].push_back(q.unit.empty() ? q.name : q.name + " [" + q.unit + "]");
  for (const Row& row : rows) {
    lines.emplace_back();
    for (const Quantity& q : header)
      lines.back().push_back(cell(row, q));
  }
  return aligned(lines);
}

/// A line per quantity, the rows from `first` to `last` side by side.
std::string beside(const Table& table, const std::vector<Quantity>& header, std::size_t first,
                   std::size_t last) {
  std::vector<std::vector<std::string>> lines;
  for (const Quantity& q : header) {
    lines.push_back({"  " + (q.unit.empty() ? q.name : q.name + " [" + q.unit + "]")});
    for (std::size_t k = first; k < last; ++k)
      lines.back().push_back(cell(table.rows[k], q));
  }
  return aligned(lines);
}

constexpr const char* run_key = "run";

/// The run that all rows belong to, or nothing.
std::string only_run(const Table& table) {
  std::string run;
  for (const Row& row : table.rows) {
    const Value* value = find_value(row, run_key);
    const std::string name = value ? shown(*value) : "";
    if (name.empty() || (!run.empty() && name != run))
      return "";
    run = name;
  }
  return run;
}

/// Several rows: a line for each, or side by side where that is too wide.
std::string in_columns(const Table& table, const std::vector<Quantity>& header) {
  constexpr std::size_t side_by_side = 6, few = 12, widest = 120; // rows, rows, letters
  const std::string wide = across(table.rows, header);
  if (table.rows.size() > few || wide.find('\n') <= widest)
    return wide;
  std::string text;
  for (std::size_t first = 0; first < table.rows.size(); first += side_by_side)
    text += (first > 0 ? "\n" : "") +
            beside(table, header, first, std::min(first + side_by_side, table.rows.size()));
  return text;
}

} // namespace

std::string shown(const Value& value) {
  return std::visit(Overloaded{[](std::monostate) { return std::string("-"); },
                               [](bool v) { return std::string(v ? "yes" : "no"); },
                               [](std::int64_t v) { return fmt::format("{}", v); },
                               [](double v) { return fmt::format("{:.5g}", v); },
                               [](const std::string& v) { return v; }},
                    value);
}

std::vector<Quantity> Table::header() const {
  if (rows.empty())
    return columns;
  std::vector<Quantity> result;
  for (const Row& row : rows)
    for (const Quantity& q : row)
      if (std::none_of(result.begin(), result.end(),
                       [&](const Quantity& known) { return known.key == q.key; }))
        result.push_back(q);
  return result;
}

const Value* find_value(const Row& row, const std::string& key) {
  for (const Quantity& q : row)
    if (q.key == key)
      return &q.value;
  return nullptr;
}

std::string as_text(const Table& table) {
  std::vector<Quantity> header = table.header();
  std::string title = table.title;
  if (const std::string run = only_run(table); !run.empty() && table.rows.size() > 1) {
    title += ": " + run;
    header.erase(std::remove_if(header.begin(), header.end(),
                                [](const Quantity& q) { return q.key == run_key; }),
                 header.end());
  }
  const std::string text = title.empty() ? "" : title + "\n";
  if (table.rows.size() == 1)
    return text + vertical(table.rows.front());
  return text + in_columns(table, header);
}

std::string as_csv(const Table& table) {
  const std::vector<Quantity> header = table.header();
  std::string text;
  for (std::size_t k = 0; k < header.size(); ++k)
    text += (k > 0 ? "," : "") + csv_field(header[k].key);
  text += "\n";
  for (const Row& row : table.rows) {
    for (std::size_t k = 0; k < header.size(); ++k) {
      const Value* value = find_value(row, header[k].key);
      text += (k > 0 ? "," : "") + (value ? csv_value(*value) : std::string());
    }
    text += "\n";
  }
  return text;
}

std::string as_json(const Table& table) {
  auto array = nlohmann::ordered_json::array();
  for (const Row& row : table.rows) {
    auto object = nlohmann::ordered_json::object();
    for (const Quantity& q : row)
      object[q.key] = json_value(q.value);
    array.push_back(std::move(object));
  }
  constexpr int indent = 2;
  return array.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void write_text(const std::string& path, const std::string& text) {
  if (path != "-" && has_been_read(path))
    throw InputError(fmt::format("{}: this file has been read and is not written over: choose "
                                 "another name for the result",
                                 path));
  std::FILE* file = path == "-" ? stdout : std::fopen(path.c_str(), "wb");
  if (!file)
    throw InputError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
  bool is_good = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  is_good = (file == stdout ? std::fflush(file) : std::fclose(file)) == 0 && is_good;
  if (!is_good)
    throw InputError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
}

} // namespace ellipsoid::post
