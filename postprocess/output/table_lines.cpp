// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "table_lines.h"

#include <algorithm>
#include <cmath>
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
                               [](double v) { return std::isnan(v) ? "" : fmt::format("{}", v); },
                               [](const std::string& v) { return csv_field(v); }},
                    value);
}

nlohmann::ordered_json json_value(const Value& value) {
  return std::visit(Overloaded{[](std::monostate) { return nlohmann::ordered_json(nullptr); },
                               [](const auto& v) { return nlohmann::ordered_json(v); }},
                    value);
}

/// The value of a key; rows have mostly the header's order, in which `next` goes along.
const Value* value_in_order(const Row& row, const std::string& key, std::size_t& next) {
  if (next < row.size() && row[next].key == key)
    return &row[next++].value;
  return find_value(row, key);
}

} // namespace

std::string shown(const Value& value) {
  return std::visit(
      Overloaded{[](std::monostate) { return std::string("-"); },
                 [](bool v) { return std::string(v ? "yes" : "no"); },
                 [](std::int64_t v) { return fmt::format("{}", v); },
                 [](double v) { return std::isnan(v) ? "-" : fmt::format("{:.5g}", v); },
                 [](const std::string& v) { return v; }},
      value);
}

std::string csv_head(const std::vector<Quantity>& header) {
  std::string text;
  for (const Quantity& q : header)
    text += (&q == &header.front() ? "" : ",") + csv_field(q.key);
  return text + "\n";
}

std::string csv_line(const Row& row, const std::vector<Quantity>& header) {
  std::string text;
  std::size_t next = 0;
  for (const Quantity& q : header) {
    const Value* value = value_in_order(row, q.key, next);
    text += (&q == &header.front() ? "" : ",") + (value ? csv_value(*value) : std::string());
  }
  return text + "\n";
}

std::string json_element(const Row& row) {
  auto object = nlohmann::ordered_json::object();
  for (const Quantity& q : row)
    object[q.key] = json_value(q.value);
  constexpr int indent = 2;
  const std::string text =
      object.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string element = "  ";
  for (const char letter : text) // words in quotes have no line ends
    element += letter == '\n' ? "\n  " : std::string(1, letter);
  return element;
}

std::vector<std::string> head_cells(const std::vector<Quantity>& header) {
  std::vector<std::string> names;
  for (const Quantity& q : header)
    names.push_back(q.unit.empty() ? q.name : q.name + " [" + q.unit + "]");
  return names;
}

std::vector<std::string> cells(const Row& row, const std::vector<Quantity>& header) {
  std::vector<std::string> texts;
  std::size_t next = 0;
  for (const Quantity& q : header) {
    const Value* value = value_in_order(row, q.key, next);
    texts.push_back(value ? shown(*value) : "-");
  }
  return texts;
}

void widen(std::vector<std::size_t>& widths, const std::vector<std::string>& cells) {
  widths.resize(std::max(widths.size(), cells.size()), 0);
  for (std::size_t k = 0; k < cells.size(); ++k)
    widths[k] = std::max(widths[k], cells[k].size());
}

std::string aligned_line(const std::vector<std::string>& cells,
                         const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k)
    line += k == 0 ? fmt::format("{:<{}}", cells[k], widths[k])
                   : fmt::format("  {:>{}}", cells[k], widths[k]);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

} // namespace ellipsoid::post
