// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "table.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// Text with the signs of HTML and SVG made harmless.
std::string html_safe(const std::string& text);

/// A table as HTML, a line per row; numbers with five digits, "+-" as one sign. The first column
/// heads its line.
std::string html_table(const Table& table, const std::string& caption);

/// The same with a line per quantity; the values of `row_key` stand above the columns.
std::string html_table_beside(const Table& table, const std::string& row_key,
                              const std::string& caption);

/// A table of any width, cut so that a printed page shows all of it: few rows stand beside each
/// other, else the columns follow in several tables, each with the first column again.
std::string html_whole_table(const Table& table, const std::string& caption);

/// A picture that is part of the page.
struct HtmlPicture {
  std::string bytes, media_type; ///< of the file; "image/svg+xml"
  std::string description;       ///< below the picture
  std::string link, link_words;  ///< beside the description; empty: none
};
std::string html_picture(const HtmlPicture& picture);
/// Several of them side by side.
std::string html_pictures(const std::vector<HtmlPicture>& pictures);

struct HtmlSection {
  std::string title, body;
};

/// A whole page with contents, its own style sheet, for wide and narrow screens, light and dark,
/// and for paper; nothing from elsewhere.
std::string html_page(const std::string& title, const std::vector<HtmlSection>& sections);

} // namespace ellipsoid::post
