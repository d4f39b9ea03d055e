// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "html.h"

#include "base64.h"

#include <fmt/format.h>

namespace ellipsoid::post {

std::string html_safe(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    if (letter == '<')
      safe += "&lt;";
    else if (letter == '>')
      safe += "&gt;";
    else if (letter == '&')
      safe += "&amp;";
    else if (letter == '"')
      safe += "&quot;";
    else
      safe += letter;
  }
  return safe;
}

namespace {

std::string named(const Quantity& q) {
  return html_safe(q.name) + (q.unit.empty() ? "" : " [" + html_safe(q.unit) + "]");
}

std::string cell(const Row& row, const std::string& key) {
  const Value* value = find_value(row, key);
  std::string text = html_safe(value ? shown(*value) : "-");
  if (const auto place = text.find(" +- "); place != std::string::npos)
    text.replace(place, 4, " ± ");
  return text;
}

/// One line of a table; `tag` is th or td.
std::string line_of(const char* tag, const std::vector<std::string>& cells) {
  std::string text = "<tr>";
  for (const std::string& words : cells)
    text += fmt::format("<{0}>{1}</{0}>", tag, words);
  return text + "</tr>\n";
}

} // namespace

std::string html_table(const Table& table) {
  std::vector<std::string> cells;
  const auto header = table.header();
  for (const Quantity& q : header)
    cells.push_back(named(q));
  std::string text = "<table>\n" + line_of("th", cells);
  for (const Row& row : table.rows) {
    cells.clear();
    for (const Quantity& q : header)
      cells.push_back(cell(row, q.key));
    text += line_of("td", cells);
  }
  return text + "</table>\n";
}

std::string html_table_beside(const Table& table, const std::string& row_key) {
  std::string text = "<table>\n", lines;
  for (const Quantity& q : table.header()) {
    std::vector<std::string> cells = {named(q)};
    for (const Row& row : table.rows)
      cells.push_back(cell(row, q.key));
    (q.key == row_key ? text : lines) += line_of(q.key == row_key ? "th" : "td", cells);
  }
  return text + lines + "</table>\n";
}

std::string html_picture(const std::string& svg, const std::string& description) {
  return fmt::format("<figure><img alt=\"{0}\" src=\"data:image/svg+xml;base64,{1}\">"
                     "<figcaption>{0}</figcaption></figure>\n",
                     html_safe(description), base64(svg));
}

std::string html_page(const std::string& title, const std::string& body) {
  constexpr const char* style =
      "body{font:16px/1.5 sans-serif;max-width:76rem;margin:2rem auto;padding:0 1rem;color:#22262b}"
      "table{border-collapse:collapse;margin:1rem 0;font-size:.85rem;display:block;overflow-x:auto}"
      "th,td{border-bottom:1px solid #d8dbe0;padding:.3rem "
      ".7rem;text-align:right}td{white-space:nowrap}"
      "th:first-child,td:first-child{text-align:left}th{background:#f2f4f7}"
      "figure{margin:1.5rem 0}img{max-width:100%;border:1px solid #e3e6ea}"
      "figcaption{color:#555;font-size:.9rem}";
  return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">"
                     "<title>{0}</title><style>{1}</style></head>\n<body>\n<h1>{0}</h1>\n{2}"
                     "</body>\n</html>\n",
                     html_safe(title), style, body);
}

} // namespace ellipsoid::post
