// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "table_charts.h"

#include "axis_scale.h"
#include "csv_table.h"
#include "input_error.h"
#include "key_units.h"
#include "legends.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace ellipsoid::post {
namespace {

/// Colours that colour-blind readers tell apart (Okabe and Ito).
const Colour line_colours[] = {{0.0, 0.45, 0.70},  {0.84, 0.37, 0.0},  {0.0, 0.62, 0.45},
                               {0.80, 0.47, 0.65}, {0.34, 0.71, 0.91}, {0.90, 0.62, 0.0}};

/// Markers on every point of a long curve would hide it.
constexpr std::size_t most_markers = 60;

void require(const Table& table, const std::string& key) {
  for (const Row& row : table.rows)
    if (find_value(row, key))
      return;
  throw InputError(fmt::format("expected a column \"{}\", {}", key, columns_found(table)));
}

/// A row's value as a number, if it has one.
bool number_at(const Row& row, const std::string& key, double& number) {
  const Value* value = find_value(row, key);
  return value && as_number(*value, number);
}

struct MapPoint {
  double x, y, value;
};

std::vector<MapPoint> map_points(const Table& table, const TableChart& what) {
  if (what.y.size() != 1)
    throw InputError("a map needs one column for --y");
  for (const std::string& key : {what.x, what.y.front(), what.value})
    require(table, key);
  std::vector<MapPoint> points;
  for (const Row& row : table.rows) {
    MapPoint p{};
    if (number_at(row, what.x, p.x) && number_at(row, what.y.front(), p.y) &&
        number_at(row, what.value, p.value))
      points.push_back(p);
  }
  return points;
}

/// Smallest distance of different values: the width of a map's rectangles.
double smallest_step(std::vector<double> values, const std::string& key) {
  std::sort(values.begin(), values.end());
  const double rounding = 1.0e-9 * (values.back() - values.front());
  double step = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k)
    if (const double d = values[k] - values[k - 1]; d > rounding && (step == 0.0 || d < step))
      step = d;
  if (step == 0.0)
    throw InputError(fmt::format("a map needs different values in column \"{}\"", key));
  return step;
}

/// One axis of a map: from values to pixels.
struct MapAxis {
  double low, high, step, begin, end; ///< values, values, values, pixels, pixels
  double at(double v) const { return begin + (v - low) / (high - low) * (end - begin); }
};

MapAxis map_axis(const std::vector<double>& values, const std::string& key, double begin,
                 double end) {
  const double step = smallest_step(values, key);
  const auto range = std::minmax_element(values.begin(), values.end());
  return {*range.first - 0.5 * step, *range.second + 0.5 * step, step, begin, end};
}

void draw_map_axes(Canvas& canvas, const MapAxis& x, const MapAxis& y, const TableChart& what,
                   double unit) {
  TextStyle text;
  text.size = 15.0 * unit;
  text.anchor = Anchor::middle;
  for (const double v : round_ticks(x.low, x.high, 6))
    canvas.text({x.at(v), y.begin + 22.0 * unit}, fmt::format("{:.6g}", v), text);
  canvas.text({0.5 * (x.begin + x.end), y.begin + 46.0 * unit}, label_of_key(what.x), text);
  text.anchor = Anchor::end;
  for (const double v : round_ticks(y.low, y.high, 6))
    canvas.text({x.begin - 8.0 * unit, y.at(v) + 5.0 * unit}, fmt::format("{:.6g}", v), text);
  text.anchor = Anchor::middle;
  text.turn_degrees = -90.0;
  canvas.text({x.begin - 70.0 * unit, 0.5 * (y.begin + y.end)}, label_of_key(what.y.front()), text);
  text.turn_degrees = 0.0;
  text.anchor = Anchor::start;
  text.is_bold = true;
  canvas.text({x.begin, y.end - 16.0 * unit}, what.title, text);
  Style frame;
  frame.line_width = 1.5 * unit;
  canvas.rectangle({x.begin, y.end}, x.end - x.begin, y.begin - y.end, frame);
}

} // namespace

std::string label_of_key(const std::string& key) {
  auto [words, unit] = parts_of_key(key);
  std::replace(words.begin(), words.end(), '_', ' ');
  return unit.empty() ? words : words + " (" + unit_in_words(unit) + ")";
}

namespace {

/// Throws InputError for a column that no row has.
void require_columns(const Table& table, const TableChart& what) {
  require(table, what.x);
  if (what.margin.size() > what.y.size())
    throw InputError(
        fmt::format("{} columns of margins for {} of curves; give at most one for each",
                    what.margin.size(), what.y.size()));
  for (const std::vector<std::string>& keys : {what.y, what.margin})
    for (const std::string& key : keys)
      require(table, key);
  if (!what.group.empty())
    require(table, what.group);
}

} // namespace

Chart curve_chart(const Table& table, const TableChart& what) {
  require_columns(table, what);
  Chart chart;
  chart.title = what.title;
  chart.x_label = label_of_key(what.x);
  chart.y_label = what.y.size() == 1 ? label_of_key(what.y.front()) : "";
  std::map<std::string, std::size_t> series_of_name;
  for (std::size_t k = 0; k < what.y.size(); ++k)
    for (const Row& row : table.rows) {
      const std::string& key = what.y[k];
      ChartPoint point;
      if (!number_at(row, what.x, point.x) || !number_at(row, key, point.y))
        continue;
      if (k < what.margin.size())
        number_at(row, what.margin[k], point.margin);
      std::string name = label_of_key(key);
      if (!what.group.empty())
        if (const Value* group = find_value(row, what.group))
          name = (what.y.size() > 1 ? name + ", " : "") + what.group + " " + shown(*group);
      const auto [entry, is_new] = series_of_name.try_emplace(name, chart.series.size());
      if (is_new) {
        Series series;
        series.name = name;
        series.colour = line_colours[chart.series.size() % std::size(line_colours)];
        chart.series.push_back(series);
      }
      chart.series[entry->second].points.push_back(point);
    }
  for (Series& series : chart.series)
    if (series.points.size() > most_markers)
      series.marker = Marker::none;
  return chart;
}

std::string draw_map(PictureFormat format, const Table& table, const TableChart& what, int width,
                     int height) {
  const std::vector<MapPoint> points = map_points(table, what);
  if (points.empty())
    throw InputError("a map needs rows with numbers in all three columns");
  const auto canvas = make_canvas(format, width, height);
  const double unit = height / 560.0;
  std::vector<double> xs, ys;
  ParticleColours scale;
  scale.low = scale.high = points.front().value;
  for (const MapPoint& p : points) {
    xs.push_back(p.x);
    ys.push_back(p.y);
    scale.low = std::min(scale.low, p.value);
    scale.high = std::max(scale.high, p.value);
  }
  scale.has_scale = true;
  scale.label = label_of_key(what.value);
  const MapAxis x = map_axis(xs, what.x, 110.0 * unit, width - 30.0 * unit);
  const MapAxis y = map_axis(ys, what.y.front(), height - 130.0 * unit, 50.0 * unit);
  const double wide = x.at(x.step) - x.at(0.0), high = y.at(0.0) - y.at(y.step);
  for (const MapPoint& p : points) {
    Style style;
    style.is_filled = true;
    style.fill = scale_colour(scale, p.value);
    style.line = style.fill; // no seams between neighbours
    style.line_width = 0.5;
    canvas->rectangle({x.at(p.x) - 0.5 * wide, y.at(p.y) - 0.5 * high}, wide, high, style);
  }
  draw_map_axes(*canvas, x, y, what, unit);
  draw_colour_bar(*canvas, {width - 30.0 * unit, height - 60.0 * unit}, scale, unit);
  return canvas->finish();
}

} // namespace ellipsoid::post
