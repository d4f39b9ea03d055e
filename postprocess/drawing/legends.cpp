// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "legends.h"

#include "axis_scale.h"

#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

constexpr Colour ink{0.13, 0.15, 0.18};

} // namespace

void draw_scale_bar(Canvas& canvas, const PixelPoint& left, double pixels_per_length,
                    double shown_length, double unit) {
  const double length = round_length(0.2 * shown_length);
  Style bar;
  bar.line = ink;
  bar.line_width = 4.0 * unit;
  const double right = left.x + length * pixels_per_length;
  canvas.line(left, {right, left.y}, bar);
  TextStyle text;
  text.size = 24.0 * unit;
  canvas.text({right + 12.0 * unit, left.y + 8.0 * unit}, fmt::format("{:g} mm", 1000.0 * length),
              text);
}

void draw_colour_bar(Canvas& canvas, const PixelPoint& corner, const ParticleColours& colours,
                     double unit) {
  const double width = 400.0 * unit, height = 18.0 * unit, left = corner.x - width;
  constexpr int steps = 100;
  Style patch;
  patch.is_filled = true;
  patch.line_width = 0.0;
  for (int k = 0; k < steps; ++k) {
    patch.fill =
        scale_colour(colours, colours.low + (colours.high - colours.low) * (k + 0.5) / steps);
    const double begin = left + width * k / steps; // to the end: no seams between the patches
    canvas.rectangle({begin, corner.y}, corner.x - begin, height, patch);
  }
  TextStyle text;
  text.size = 20.0 * unit;
  const double baseline = corner.y + height + 24.0 * unit;
  canvas.text({left, baseline}, fmt::format("{:.4g}", colours.low), text);
  text.anchor = Anchor::end;
  canvas.text({corner.x, baseline}, fmt::format("{:.4g}", colours.high), text);
  text.anchor = Anchor::middle;
  canvas.text({0.5 * (left + corner.x), baseline}, colours.label, text);
}

} // namespace ellipsoid::post
