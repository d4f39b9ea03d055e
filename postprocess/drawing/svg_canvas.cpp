// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "svg_canvas.h"

#include "base64.h"
#include "html.h"

#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

std::string hex(const Colour& colour) {
  const auto byte = [](double share) {
    return static_cast<int>(std::lround(255.0 * std::fmin(1.0, std::fmax(0.0, share))));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green),
                     byte(colour.blue));
}

std::string attributes(const Style& style) {
  std::string text = style.is_filled ? fmt::format(" fill=\"{}\"", hex(style.fill))
                                     : std::string(" fill=\"none\"");
  if (style.is_filled && style.fill_opacity < 1.0)
    text += fmt::format(" fill-opacity=\"{:.3g}\"", style.fill_opacity);
  if (style.line_width > 0.0)
    text +=
        fmt::format(" stroke=\"{}\" stroke-width=\"{:.4g}\"", hex(style.line), style.line_width);
  if (!style.dashes.empty()) {
    text += " stroke-dasharray=\"";
    for (const double dash : style.dashes)
      text += fmt::format("{:.4g} ", dash);
    text.back() = '"';
  }
  return text;
}

} // namespace

SvgCanvas::SvgCanvas(int width, int height) {
  text_ = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" "
                      "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{0}\" height=\"{1}\" "
                      "viewBox=\"0 0 {0} {1}\" font-family=\"DejaVu Sans, Arial, sans-serif\">\n"
                      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
                      width, height);
}

void SvgCanvas::ellipse(const PixelPoint& centre, double a, double b, double turn_degrees,
                        const Style& style) {
  if (a == b) {
    text_ += fmt::format("<circle cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"{:.3f}\"{}/>\n", centre.x,
                         centre.y, a, attributes(style));
    return;
  }
  text_ += fmt::format("<ellipse rx=\"{:.3f}\" ry=\"{:.3f}\" "
                       "transform=\"translate({:.3f} {:.3f}) rotate({:.3f})\"{}/>\n",
                       a, b, centre.x, centre.y, turn_degrees, attributes(style));
}

void SvgCanvas::polyline(const std::vector<PixelPoint>& points, bool is_closed,
                         const Style& style) {
  text_ += is_closed ? "<polygon points=\"" : "<polyline points=\"";
  for (const PixelPoint& p : points)
    text_ += fmt::format("{:.3f},{:.3f} ", p.x, p.y);
  text_ += fmt::format("\"{} stroke-linejoin=\"round\"/>\n", attributes(style));
}

void SvgCanvas::text(const PixelPoint& position, const std::string& words, const TextStyle& style) {
  const char* anchor = style.anchor == Anchor::start    ? "start"
                       : style.anchor == Anchor::middle ? "middle"
                                                        : "end";
  std::string turn;
  if (style.turn_degrees != 0.0)
    turn = fmt::format(" transform=\"rotate({:.2f} {:.3f} {:.3f})\"", style.turn_degrees,
                       position.x, position.y);
  std::string spans;
  bool was_subscript = false;
  for (const TextPart& part : text_parts(words)) {
    const double step = part.is_subscript ? subscript_depth : -subscript_depth;
    const double size = part.is_subscript ? subscript_size * style.size : style.size;
    spans += part.is_subscript == was_subscript
                 ? html_safe(part.words)
                 : fmt::format("<tspan dy=\"{:.3f}\" font-size=\"{:.4g}\">{}</tspan>",
                               step * style.size, size, html_safe(part.words));
    was_subscript = part.is_subscript;
  }
  text_ += fmt::format(
      "<text x=\"{:.3f}\" y=\"{:.3f}\" font-size=\"{:.4g}\" text-anchor=\"{}\" fill=\"{}\"{}{}>{}"
      "</text>\n",
      position.x, position.y, style.size, anchor, hex(style.colour),
      style.is_bold ? " font-weight=\"bold\"" : "", turn, spans);
}

void SvgCanvas::image(const PixelPoint& corner, const PixelImage& pixels) {
  text_ += fmt::format("<image x=\"{:.3f}\" y=\"{:.3f}\" width=\"{}\" height=\"{}\" "
                       "xlink:href=\"data:image/png;base64,{}\"/>\n",
                       corner.x, corner.y, pixels.width, pixels.height, base64(png_bytes(pixels)));
}

void SvgCanvas::begin_clip(const PixelPoint& corner, double width, double height) {
  ++clips_;
  text_ += fmt::format("<clipPath id=\"clip{0}\"><rect x=\"{1:.3f}\" y=\"{2:.3f}\" "
                       "width=\"{3:.3f}\" height=\"{4:.3f}\"/></clipPath>\n"
                       "<g clip-path=\"url(#clip{0})\">\n",
                       clips_, corner.x, corner.y, width, height);
}

void SvgCanvas::end_clip() { text_ += "</g>\n"; }

std::string SvgCanvas::finish() { return text_ + "</svg>\n"; }

} // namespace ellipsoid::post
