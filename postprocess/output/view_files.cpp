// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "view_files.h"

#include <fstream>

#include "view_sources.h" // made at build time from the files of view/

namespace ellipsoid::post {
namespace {

void put(std::string& page, const std::string& name, const std::string& value) {
  const std::string mark = "@" + name + "@";
  if (const auto at = page.find(mark); at != std::string::npos)
    page.replace(at, mark.size(), value);
}

} // namespace

std::string view_html(const std::map<std::string, std::string>& values) {
  std::string page = view_sources::page_html;
  std::string script;
  for (const char* part :
       {view_sources::data_js, view_sources::camera_js, view_sources::shaders_js,
        view_sources::drawing_js, view_sources::scene_js, view_sources::panel_js})
    script += part;
  put(page, "SCRIPT", script); // the last mark first: values may be long
  for (const auto& [name, value] : values)
    put(page, name, value);
  put(page, "STYLE", view_sources::style_css);
  return page;
}

bool is_view_page(const std::string& path) {
  std::string begin(1000, '\0');
  std::ifstream(path, std::ios::binary)
      .read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin.find("name=\"generator\" content=\"ellipsoid-post view\"") != std::string::npos;
}

} // namespace ellipsoid::post
