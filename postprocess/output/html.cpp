// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "html.h"

#include "base64.h"
#include "html_style.h"

#include <algorithm>
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
  if (const auto at = text.find(" +- "); at != std::string::npos)
    text.replace(at, 4, " ± ");
  return text;
}

std::string head_of(const std::vector<std::string>& cells) {
  std::string text = "<thead><tr>";
  for (const std::string& words : cells)
    text += "<th scope=\"col\">" + words + "</th>";
  return text + "</tr></thead>\n";
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string text = "<tr><th scope=\"row\">" + cells.front() + "</th>";
  for (std::size_t k = 1; k < cells.size(); ++k)
    text += "<td>" + cells[k] + "</td>";
  return text + "</tr>\n";
}

std::string table_of(const std::string& caption, const std::string& head,
                     const std::string& lines) {
  // with the keyboard, too, one can scroll what is wider than the screen
  return "<div class=\"wide\" tabindex=\"0\"><table>\n<caption>" + html_safe(caption) +
         "</caption>\n" + head + "<tbody>\n" + lines + "</tbody></table></div>\n";
}

/// The columns [begin, end) of a table, and the first one.
std::string some_columns(const Table& table, const std::vector<Quantity>& header, std::size_t begin,
                         std::size_t end, const std::string& caption) {
  const auto cells_of = [&](const auto& text_of) {
    std::vector<std::string> cells = {text_of(header.front())};
    for (std::size_t k = begin; k < end; ++k)
      cells.push_back(text_of(header[k]));
    return cells;
  };
  std::string lines;
  for (const Row& row : table.rows)
    lines += line_of(cells_of([&](const Quantity& q) { return cell(row, q.key); }));
  return table_of(caption, head_of(cells_of(named)), lines);
}

std::string anchor_of(const std::string& title) {
  std::string anchor;
  for (const char letter : title)
    anchor += letter >= 'A' && letter <= 'Z'   ? static_cast<char>(letter - 'A' + 'a')
              : letter >= 'a' && letter <= 'z' ? letter
                                               : '-';
  return anchor;
}

} // namespace

std::string html_table(const Table& table, const std::string& caption) {
  const auto header = table.header();
  return header.empty() ? "" : some_columns(table, header, 1, header.size(), caption);
}

std::string html_table_beside(const Table& table, const std::string& row_key,
                              const std::string& caption) {
  std::string head, lines;
  for (const Quantity& q : table.header()) {
    std::vector<std::string> cells = {named(q)};
    for (const Row& row : table.rows)
      cells.push_back(cell(row, q.key));
    if (q.key == row_key)
      head = head_of(cells);
    else
      lines += line_of(cells);
  }
  return table_of(caption, head, lines);
}

std::string html_whole_table(const Table& table, const std::string& caption) {
  constexpr std::size_t most_columns = 8, most_beside = 6; // of a sheet of paper
  const auto header = table.header();
  if (header.size() <= most_columns)
    return html_table(table, caption);
  if (table.rows.size() <= most_beside)
    return html_table_beside(table, header.front().key, caption);
  const std::size_t others = header.size() - 1,
                    tables = (others + most_columns - 2) / (most_columns - 1);
  std::string text;
  for (std::size_t k = 0; k < tables; ++k)
    text += some_columns(table, header, 1 + k * others / tables, 1 + (k + 1) * others / tables,
                         fmt::format("{} ({} of {})", caption, k + 1, tables));
  return text;
}

std::string html_picture(const HtmlPicture& picture) {
  const std::string description = html_safe(picture.description);
  const std::string link = picture.link.empty()
                               ? ""
                               : fmt::format(" <a href=\"{}\">{}</a>", html_safe(picture.link),
                                             html_safe(picture.link_words));
  return fmt::format("<figure><img alt=\"{0}\" src=\"data:{1};base64,{2}\">"
                     "<figcaption>{0}{3}</figcaption></figure>\n",
                     description, picture.media_type, base64(picture.bytes), link);
}

std::string html_pictures(const std::vector<HtmlPicture>& pictures) {
  std::string text = "<div class=\"pictures\">\n";
  for (const HtmlPicture& picture : pictures)
    text += html_picture(picture);
  return text + "</div>\n";
}

std::string html_page(const std::string& title, const std::vector<HtmlSection>& sections) {
  std::string contents, body;
  for (const HtmlSection& section : sections) {
    const std::string name = html_safe(section.title), anchor = anchor_of(section.title);
    contents += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", anchor, name);
    body +=
        fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", anchor, name, section.body);
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<title>{0}</title><style>{1}</style></head>\n<body>\n<h1>{0}</h1>\n"
      "<nav aria-label=\"Contents\"><ul>\n{2}</ul></nav>\n<main>\n{3}</main>\n</body>\n</html>\n",
      html_safe(title), html_style, contents, body);
}

} // namespace ellipsoid::post
