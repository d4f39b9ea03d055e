// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "table.h"

#include <string>

namespace ellipsoid::post {

/// Text with the signs of HTML made harmless.
std::string html_safe(const std::string& text);

/// A table as HTML; numbers with five digits.
std::string html_table(const Table& table);

/// An image element that holds the SVG itself.
std::string html_picture(const std::string& svg, const std::string& description);

/// A whole page with its own style sheet and nothing from elsewhere.
std::string html_page(const std::string& title, const std::string& body);

} // namespace ellipsoid::post
