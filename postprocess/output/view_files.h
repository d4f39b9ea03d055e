// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <map>
#include <string>

namespace ellipsoid::post {

/// The page of folder view/ with its style sheet and scripts, and with the values in place of
/// @NAME@. The files are part of the program (see view/CMakeLists.txt).
std::string view_html(const std::map<std::string, std::string>& values);

/// Whether a file begins as such a page does.
bool is_view_page(const std::string& path);

} // namespace ellipsoid::post
