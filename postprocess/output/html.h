// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "table.h"

#include <string>

namespace ellipsoid::post {

/// Text with the signs of HTML made harmless.
std::string html_safe(const std::string& text);

/// A table as HTML, a line per row; numbers with five digits, "+-" as one sign.
std::string html_table(const Table& table);

/// The same with a line per quantity; the values of `row_key` stand above the columns.
std::string html_table_beside(const Table& table, const std::string& row_key);

/// An image element that holds the SVG itself.
std::string html_picture(const std::string& svg, const std::string& description);

/// A whole page with its own style sheet and nothing from elsewhere.
std::string html_page(const std::string& title, const std::string& body);

} // namespace ellipsoid::post
