// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "canvas.h"

#include "input_error.h"
#include "svg_canvas.h"

#ifdef ELLIPSOID_HAS_CAIRO
#include "cairo_canvas.h"
#endif

namespace ellipsoid::post {

std::vector<TextPart> text_parts(const std::string& words) {
  std::vector<TextPart> parts;
  std::size_t begin = 0;
  while (begin < words.size()) {
    const std::size_t mark = words.find("_{", begin), end = words.find('}', mark);
    if (mark == words.npos || end == words.npos) {
      parts.push_back({words.substr(begin), false});
      break;
    }
    if (mark > begin)
      parts.push_back({words.substr(begin, mark - begin), false});
    parts.push_back({words.substr(mark + 2, end - mark - 2), true});
    begin = end + 1;
  }
  return parts;
}

PictureFormat picture_format(const std::string& path) {
  const std::string ending = path.size() > 4 ? path.substr(path.size() - 4) : "";
  if (ending == ".svg")
    return PictureFormat::svg;
  if (ending == ".png")
    return PictureFormat::png;
  throw InputError(path + ": a picture's name ends in .svg or .png");
}

bool draws_png() {
#ifdef ELLIPSOID_HAS_CAIRO
  return true;
#else
  return false;
#endif
}

std::unique_ptr<Canvas> make_canvas(PictureFormat format, int width, int height) {
  if (format == PictureFormat::svg)
    return std::make_unique<SvgCanvas>(width, height);
#ifdef ELLIPSOID_HAS_CAIRO
  return std::make_unique<CairoCanvas>(width, height);
#else
  throw InputError("this build draws no PNG because cairo was not found (Debian: "
                   "libcairo2-dev); choose a name that ends in .svg");
#endif
}

} // namespace ellipsoid::post
