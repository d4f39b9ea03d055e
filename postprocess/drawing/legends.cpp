// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "legends.h"

#include "axis_scale.h"

#include <fmt/format.h>
#include <utility>
#include <vector>

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

namespace {

/// The bar itself, or a patch for each kind.
void draw_patches(Canvas& canvas, const PixelPoint& left, double width, double height,
                  const ParticleColours& colours) {
  const bool has_kinds = !colours.kinds.empty();
  const std::size_t steps = has_kinds ? colours.kinds.size() : 100;
  Style patch;
  patch.is_filled = true;
  patch.line_width = 0.0;
  for (std::size_t k = 0; k < steps; ++k) {
    const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(steps);
    patch.fill = scale_colour(
        colours, has_kinds ? colours.kinds[k] : colours.low + (colours.high - colours.low) * share);
    // to the end: no seams between the patches
    const double begin = left.x + width * static_cast<double>(k) / static_cast<double>(steps);
    canvas.rectangle({begin, left.y}, left.x + width - begin, height, patch);
  }
}

/// Where numbers stand below the bar, as shares of its width, and the numbers.
std::vector<std::pair<double, double>> labels_below(const ParticleColours& colours) {
  std::vector<std::pair<double, double>> labels;
  const auto count = static_cast<double>(colours.kinds.size());
  for (std::size_t k = 0; k < colours.kinds.size(); ++k)
    labels.emplace_back((static_cast<double>(k) + 0.5) / count, colours.kinds[k]);
  if (!labels.empty())
    return labels;
  const double width = colours.high - colours.low;
  constexpr int wanted = 5;
  const auto ticks = colours.is_cyclic ? std::vector<double>{0.0, 45.0, 90.0, 135.0, 180.0}
                                       : round_ticks(colours.low, colours.high, wanted);
  for (const double value : ticks)
    if (width > 0.0 && value >= colours.low && value <= colours.high)
      labels.emplace_back((value - colours.low) / width, value);
  if (labels.size() < 2)
    labels = {{0.0, colours.low}, {1.0, colours.high}};
  return labels;
}

} // namespace

void draw_colour_bar(Canvas& canvas, const PixelPoint& corner, const ParticleColours& colours,
                     double unit) {
  const double width = 400.0 * unit, height = 18.0 * unit, left = corner.x - width;
  draw_patches(canvas, {left, corner.y}, width, height, colours);
  Style tick;
  tick.line = ink;
  tick.line_width = 1.5 * unit;
  TextStyle text;
  text.size = 20.0 * unit;
  text.anchor = Anchor::middle;
  const double foot = corner.y + height;
  for (const auto& [share, value] : labels_below(colours)) {
    const double x = left + share * width;
    if (colours.kinds.empty())
      canvas.line({x, foot}, {x, foot + 6.0 * unit}, tick);
    canvas.text({x, foot + 26.0 * unit}, fmt::format("{:.4g}", value), text);
  }
  canvas.text({left + 0.5 * width, corner.y - 8.0 * unit}, colours.label, text);
}

} // namespace ellipsoid::post
