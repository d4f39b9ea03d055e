// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "cairo_canvas.h"

#include "input_error.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

cairo_status_t append_bytes(void* to, const unsigned char* bytes, unsigned length) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), length);
  return CAIRO_STATUS_SUCCESS;
}

void set_colour(cairo_t* cairo, const Colour& c, double opacity) {
  cairo_set_source_rgba(cairo, c.red, c.green, c.blue, opacity);
}

} // namespace

CairoCanvas::CairoCanvas(int width, int height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      cairo_(cairo_create(surface_)) {
  set_colour(cairo_, {1.0, 1.0, 1.0}, 1.0);
  cairo_paint(cairo_);
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
}

CairoCanvas::~CairoCanvas() {
  cairo_destroy(cairo_);
  cairo_surface_destroy(surface_);
}

void CairoCanvas::paint(const Style& style) {
  if (style.is_filled) {
    set_colour(cairo_, style.fill, style.fill_opacity);
    cairo_fill_preserve(cairo_);
  }
  if (style.line_width > 0.0) {
    set_colour(cairo_, style.line, 1.0);
    cairo_set_line_width(cairo_, style.line_width);
    cairo_set_dash(cairo_, style.dashes.data(), static_cast<int>(style.dashes.size()), 0.0);
    cairo_stroke_preserve(cairo_);
  }
  cairo_new_path(cairo_);
}

void CairoCanvas::ellipse(const PixelPoint& centre, double a, double b, double turn_degrees,
                          const Style& style) {
  cairo_save(cairo_);
  cairo_translate(cairo_, centre.x, centre.y);
  cairo_rotate(cairo_, turn_degrees * pi / 180.0);
  cairo_scale(cairo_, a, b);
  cairo_arc(cairo_, 0.0, 0.0, 1.0, 0.0, 2.0 * pi);
  cairo_close_path(cairo_);
  cairo_restore(cairo_); // the line's width is not scaled
  paint(style);
}

void CairoCanvas::polyline(const std::vector<PixelPoint>& points, bool is_closed,
                           const Style& style) {
  for (const PixelPoint& p : points)
    cairo_line_to(cairo_, p.x, p.y);
  if (is_closed)
    cairo_close_path(cairo_);
  paint(style);
}

void CairoCanvas::text(const PixelPoint& position, const std::string& words,
                       const TextStyle& style) {
  cairo_save(cairo_);
  cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  const std::vector<TextPart> parts = text_parts(words);
  const auto choose_size = [&](const TextPart& part) {
    cairo_set_font_size(cairo_, (part.is_subscript ? subscript_size : 1.0) * style.size);
  };
  std::vector<double> widths;
  double width = 0.0;
  for (const TextPart& part : parts) {
    cairo_text_extents_t extents;
    choose_size(part);
    cairo_text_extents(cairo_, part.words.c_str(), &extents);
    widths.push_back(extents.x_advance);
    width += extents.x_advance;
  }
  const double share = style.anchor == Anchor::start    ? 0.0
                       : style.anchor == Anchor::middle ? 0.5
                                                        : 1.0;
  cairo_translate(cairo_, position.x, position.y);
  cairo_rotate(cairo_, style.turn_degrees * pi / 180.0);
  set_colour(cairo_, style.colour, 1.0);
  double begin = -share * width;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    choose_size(parts[k]);
    cairo_move_to(cairo_, begin, parts[k].is_subscript ? subscript_depth * style.size : 0.0);
    cairo_show_text(cairo_, parts[k].words.c_str());
    begin += widths[k];
  }
  cairo_restore(cairo_);
  cairo_new_path(cairo_);
}

void CairoCanvas::image(const PixelPoint& corner, const PixelImage& pixels) {
  const int width = static_cast<int>(pixels.width), height = static_cast<int>(pixels.height);
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  unsigned char* const bytes = cairo_image_surface_get_data(surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  for (std::size_t row = 0; row < pixels.height; ++row)
    for (std::size_t column = 0; column < pixels.width; ++column) {
      const std::uint8_t* const rgb = &pixels.samples[3 * (row * pixels.width + column)];
      const auto value = static_cast<std::uint32_t>(rgb[0] << 16 | rgb[1] << 8 | rgb[2]);
      std::memcpy(bytes + row * stride + 4 * column, &value, sizeof value);
    }
  cairo_surface_mark_dirty(surface);
  cairo_set_source_surface(cairo_, surface, corner.x, corner.y);
  cairo_paint(cairo_);
  cairo_surface_destroy(surface);
}

void CairoCanvas::begin_clip(const PixelPoint& corner, double width, double height) {
  cairo_save(cairo_);
  cairo_rectangle(cairo_, corner.x, corner.y, width, height);
  cairo_clip(cairo_);
}

void CairoCanvas::end_clip() { cairo_restore(cairo_); }

std::string CairoCanvas::finish() {
  std::string bytes;
  cairo_surface_flush(surface_);
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_, append_bytes, &bytes);
  if (status != CAIRO_STATUS_SUCCESS)
    throw InputError(std::string("the picture cannot be written: ") +
                     cairo_status_to_string(status));
  return bytes;
}

} // namespace ellipsoid::post
