// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "chart.h"

#include "axis_scale.h"
#include "colour_map.h"
#include "input_error.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace ellipsoid::post {
namespace {

constexpr Colour ink{0.13, 0.15, 0.18}, pale{0.88, 0.89, 0.91};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void widen(double share) {
    const double room = high > low ? share * (high - low) : std::max(0.5, 0.1 * std::abs(high));
    low -= room;
    high += room;
  }
};

/// One chart's frame in pixels and its data ranges.
struct ChartFrame {
  double left, top, width, height, unit; ///< pixels; unit: of letters and lines
  Range x, y;

  PixelPoint at(double px, double py) const {
    return {left + (px - x.low) / (x.high - x.low) * width,
            top + (y.high - py) / (y.high - y.low) * height};
  }
};

Style stroke(const Colour& colour, double width) {
  Style style;
  style.line = colour;
  style.line_width = width;
  return style;
}

Style filling(const Colour& colour, double opacity) {
  Style style;
  style.is_filled = true;
  style.fill = colour;
  style.fill_opacity = opacity;
  style.line_width = 0.0;
  return style;
}

void set_ranges(ChartFrame& frame, const Chart& chart) {
  for (const Series& series : chart.series)
    for (const ChartPoint& p : series.points) {
      frame.x.add(p.x);
      frame.y.add(p.y - p.margin);
      frame.y.add(p.y + p.margin);
    }
  for (const Band& band : chart.bands) {
    frame.y.add(band.y - band.margin);
    frame.y.add(band.y + band.margin);
  }
  if (!(frame.x.low <= frame.x.high))
    throw InputError(fmt::format("figure \"{}\": the input has no points for it", chart.title));
  frame.x.widen(0.05);
  frame.y.widen(0.08);
  frame.y.low = chart.y_low.value_or(frame.y.low);
  frame.y.high = chart.y_high.value_or(frame.y.high);
}

void draw_axes(Canvas& canvas, const ChartFrame& f, const Chart& chart) {
  const Style grid = stroke(pale, f.unit), axis = stroke(ink, 1.5 * f.unit);
  TextStyle text;
  text.size = 15.0 * f.unit;
  text.colour = ink;
  text.anchor = Anchor::end;
  for (const double y : round_ticks(f.y.low, f.y.high, 6)) {
    const PixelPoint p = f.at(f.x.low, y);
    canvas.line(p, {f.left + f.width, p.y}, grid);
    canvas.text({p.x - 8.0 * f.unit, p.y + 5.0 * f.unit}, fmt::format("{:.6g}", y), text);
  }
  text.anchor = Anchor::middle;
  const auto ticks = chart.x_ticks.empty() ? round_ticks(f.x.low, f.x.high, 7) : chart.x_ticks;
  for (const double x : ticks) {
    if (x < f.x.low || x > f.x.high)
      continue;
    const PixelPoint p = f.at(x, f.y.low);
    canvas.line(p, {p.x, p.y + 6.0 * f.unit}, axis);
    canvas.text({p.x, p.y + 24.0 * f.unit}, fmt::format("{:.6g}", x), text);
  }
  canvas.rectangle({f.left, f.top}, f.width, f.height, axis);
  text.size = 17.0 * f.unit;
  canvas.text({f.left + 0.5 * f.width, f.top + f.height + 52.0 * f.unit}, chart.x_label, text);
  text.turn_degrees = -90.0;
  canvas.text({f.left - 62.0 * f.unit, f.top + 0.5 * f.height}, chart.y_label, text);
  text.turn_degrees = 0.0;
  text.is_bold = true;
  text.anchor = Anchor::start;
  canvas.text({f.left, f.top - 16.0 * f.unit}, chart.title, text);
}

void draw_marker(Canvas& canvas, const PixelPoint& p, const Series& series, double size) {
  Style style = stroke(series.colour, 0.3 * size);
  style.is_filled = true;
  style.fill = series.is_filled ? series.colour : Colour{1.0, 1.0, 1.0};
  switch (series.marker) {
  case Marker::circle:
    canvas.ellipse(p, size, size, 0.0, style);
    break;
  case Marker::square:
    canvas.rectangle({p.x - size, p.y - size}, 2.0 * size, 2.0 * size, style);
    break;
  case Marker::triangle:
    canvas.polyline({{p.x, p.y - 1.2 * size},
                     {p.x + 1.1 * size, p.y + 0.9 * size},
                     {p.x - 1.1 * size, p.y + 0.9 * size}},
                    true, style);
    break;
  case Marker::diamond:
    canvas.polyline({{p.x, p.y - 1.3 * size},
                     {p.x + 1.3 * size, p.y},
                     {p.x, p.y + 1.3 * size},
                     {p.x - 1.3 * size, p.y}},
                    true, style);
    break;
  case Marker::none:
    break;
  }
}

void draw_series(Canvas& canvas, const ChartFrame& f, const Series& series) {
  Style line = stroke(series.colour, 2.0 * f.unit);
  if (series.is_dashed)
    line.dashes = {7.0 * f.unit, 5.0 * f.unit};
  std::vector<PixelPoint> path;
  for (const ChartPoint& p : series.points)
    path.push_back(f.at(p.x, p.y));
  if (series.is_joined && path.size() > 1)
    canvas.polyline(path, false, line);
  line.dashes.clear();
  for (const ChartPoint& p : series.points) {
    if (p.margin > 0.0) {
      const PixelPoint low = f.at(p.x, p.y - p.margin), high = f.at(p.x, p.y + p.margin);
      const double cap = 5.0 * f.unit;
      canvas.line(low, high, line);
      canvas.line({low.x - cap, low.y}, {low.x + cap, low.y}, line);
      canvas.line({high.x - cap, high.y}, {high.x + cap, high.y}, line);
    }
    draw_marker(canvas, f.at(p.x, p.y), series, 5.0 * f.unit);
  }
}

void draw_band(Canvas& canvas, const ChartFrame& f, const Band& band) {
  const PixelPoint high = f.at(f.x.low, band.y + band.margin);
  const PixelPoint low = f.at(f.x.high, band.y - band.margin);
  if (band.margin > 0.0)
    canvas.rectangle(high, low.x - high.x, low.y - high.y, filling(band.colour, 0.15));
  Style line = stroke(band.colour, 2.0 * f.unit);
  if (band.is_dashed)
    line.dashes = {7.0 * f.unit, 5.0 * f.unit};
  canvas.line(f.at(f.x.low, band.y), f.at(f.x.high, band.y), line);
}

/// Names below the chart's frame, in two columns.
void draw_legend(Canvas& canvas, const ChartFrame& f, const Chart& chart) {
  TextStyle text;
  text.size = 14.0 * f.unit;
  text.colour = ink;
  std::size_t entry = 0;
  const auto position = [&] {
    const double column = static_cast<double>(entry % 2), line = static_cast<double>(entry / 2);
    ++entry;
    return PixelPoint{f.left + column * 0.5 * f.width,
                      f.top + f.height + (80.0 + 24.0 * line) * f.unit};
  };
  const auto name_at = [&](const PixelPoint& p, const std::string& name) {
    canvas.text({p.x + 42.0 * f.unit, p.y + 5.0 * f.unit}, name, text);
  };
  for (const Series& series : chart.series) {
    const PixelPoint p = position();
    Style line = stroke(series.colour, 2.0 * f.unit);
    if (series.is_dashed)
      line.dashes = {7.0 * f.unit, 5.0 * f.unit};
    if (series.is_joined)
      canvas.line(p, {p.x + 34.0 * f.unit, p.y}, line);
    draw_marker(canvas, {p.x + 17.0 * f.unit, p.y}, series, 5.0 * f.unit);
    name_at(p, series.name);
  }
  for (const Band& band : chart.bands) {
    const PixelPoint p = position();
    Style line = stroke(band.colour, 2.0 * f.unit);
    if (band.is_dashed)
      line.dashes = {7.0 * f.unit, 5.0 * f.unit};
    canvas.line(p, {p.x + 34.0 * f.unit, p.y}, line);
    name_at(p, band.name);
  }
}

} // namespace

std::string draw_charts(PictureFormat format, const std::vector<Chart>& charts, int width,
                        int height) {
  const auto canvas = make_canvas(format, width, height);
  const double unit = height / 560.0;
  std::size_t most_entries = 0;
  for (const Chart& chart : charts)
    most_entries = std::max(most_entries, chart.series.size() + chart.bands.size());
  const double legend = (70.0 + 24.0 * static_cast<double>((most_entries + 1) / 2)) * unit;
  const double panel = width / static_cast<double>(charts.size());
  for (std::size_t k = 0; k < charts.size(); ++k) {
    ChartFrame frame{static_cast<double>(k) * panel + 90.0 * unit,
                     50.0 * unit,
                     panel - 115.0 * unit,
                     height - 60.0 * unit - legend,
                     unit,
                     {},
                     {}};
    set_ranges(frame, charts[k]);
    draw_axes(*canvas, frame, charts[k]);
    canvas->begin_clip({frame.left, frame.top}, frame.width, frame.height);
    for (const Band& band : charts[k].bands)
      draw_band(*canvas, frame, band);
    for (const Series& series : charts[k].series)
      draw_series(*canvas, frame, series);
    canvas->end_clip();
    draw_legend(*canvas, frame, charts[k]);
  }
  return canvas->finish();
}

} // namespace ellipsoid::post
