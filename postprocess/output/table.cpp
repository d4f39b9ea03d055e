// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "table.h"

#include "table_lines.h"
#include "written_file.h"

#include <algorithm>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// Columns of text with the widest entry's width; the first one to the left.
std::string aligned(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths;
  for (const auto& line : lines)
    widen(widths, line);
  std::string text;
  for (const auto& line : lines)
    text += aligned_line(line, widths);
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

/// A line per row of the table.
std::string across(const std::vector<Row>& rows, const std::vector<Quantity>& header) {
  std::vector<std::vector<std::string>> lines{head_cells(header)};
  for (const Row& row : rows)
    lines.push_back(cells(row, header));
  return aligned(lines);
}

/// A line per quantity, the rows from `first` to `last` side by side.
std::string beside(const Table& table, const std::vector<Quantity>& header, std::size_t first,
                   std::size_t last) {
  std::vector<std::vector<std::string>> lines;
  for (const Quantity& q : header) {
    lines.push_back({"  " + head_cells({q}).front()});
    for (std::size_t k = first; k < last; ++k)
      lines.back().push_back(cells(table.rows[k], {q}).front());
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
  std::string text = csv_head(header);
  for (const Row& row : table.rows)
    text += csv_line(row, header);
  return text;
}

std::string as_json(const Table& table) {
  std::string text;
  for (const Row& row : table.rows)
    text += (text.empty() ? "[\n" : ",\n") + json_element(row);
  return text.empty() ? "[]\n" : text + "\n]\n";
}

void write_text(const std::string& path, const std::string& text) {
  WrittenFile file(path);
  file.write(text);
  file.close();
}

} // namespace ellipsoid::post
