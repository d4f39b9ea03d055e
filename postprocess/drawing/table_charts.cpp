// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "table_charts.h"

#include "axis_scale.h"
#include "csv_table.h"
#include "input_error.h"
#include "key_units.h"
#include "legends.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <optional>
#include <set>

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

/// A row's value as a number, if it has one: nan and inf are none.
bool number_at(const Row& row, const std::string& key, double& number) {
  const Value* value = find_value(row, key);
  return value && as_number(*value, number) && std::isfinite(number);
}

/// Rows that have a column, and how many of them lack a number in it or in a second column.
struct RowsWithout {
  std::size_t rows = 0, without = 0;
};

RowsWithout rows_without(const Table& table, const std::string& key, const std::string& second) {
  RowsWithout count;
  for (const Row& row : table.rows) {
    double number = 0.0;
    if (!find_value(row, key))
      continue; // of a file that has others
    ++count.rows;
    count.without += number_at(row, key, number) && number_at(row, second, number) ? 0 : 1;
  }
  return count;
}

void append_sentence(std::string& text, const std::string& more) {
  text += (text.empty() ? "" : "; ") + more;
}

struct MapPoint {
  double x, y;
  std::optional<double> value;
};

std::vector<MapPoint> map_points(const Table& table, const TableChart& what) {
  if (what.y.size() != 1)
    throw InputError("a map needs one column for --y");
  for (const std::string& key : {what.x, what.y.front(), what.value})
    require(table, key);
  std::vector<MapPoint> points;
  for (const Row& row : table.rows) {
    MapPoint p{};
    double value = 0.0;
    if (!number_at(row, what.x, p.x) || !number_at(row, what.y.front(), p.y))
      continue;
    if (number_at(row, what.value, value))
      p.value = value;
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
  std::int64_t cell(double v) const { return std::llround((v - low) / step - 0.5); }
  std::int64_t cells() const { return std::llround((high - low) / step); }
};

MapAxis map_axis(const std::vector<double>& values, const std::string& key, double begin = 0.0,
                 double end = 1.0) {
  const double step = smallest_step(values, key);
  const auto range = std::minmax_element(values.begin(), values.end());
  return {*range.first - 0.5 * step, *range.second + 0.5 * step, step, begin, end};
}

/// One coordinate of all points.
std::vector<double> values_of(const std::vector<MapPoint>& points, double MapPoint::*coordinate) {
  std::vector<double> values;
  for (const MapPoint& p : points)
    values.push_back(p.*coordinate);
  return values;
}

/// The colours of all values. Throws InputError where there are none.
ParticleColours scale_of(const std::vector<MapPoint>& points, const TableChart& what) {
  ParticleColours scale;
  for (const MapPoint& p : points) {
    if (!p.value)
      continue;
    scale.low = scale.has_scale ? std::min(scale.low, *p.value) : *p.value;
    scale.high = scale.has_scale ? std::max(scale.high, *p.value) : *p.value;
    scale.has_scale = true;
  }
  if (!scale.has_scale)
    throw InputError("a map needs rows with numbers in all three columns");
  scale.label = label_of_key(what.value);
  return scale;
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
  if (key.size() == 3 && key[1] == '_') // b_a: the ratio of two semi-axes
    return {key[0], '/', key[2]};
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
      if (double margin = 0.0; k < what.margin.size() && number_at(row, what.margin[k], margin))
        point.margin = margin;
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
  if (chart.series.empty())
    throw InputError(fmt::format("no row has a number in both \"{}\" and \"{}\": choose columns "
                                 "that have them",
                                 what.x, fmt::join(what.y, "\" or \"")));
  for (Series& series : chart.series)
    if (series.points.size() > most_markers)
      series.marker = Marker::none;
  return chart;
}

std::string left_out_of_curves(const Table& table, const TableChart& what) {
  std::string text;
  for (const std::string& key : what.y)
    if (const RowsWithout of_curve = rows_without(table, key, what.x); of_curve.without > 0)
      append_sentence(text, fmt::format("{} of {} rows have no number in \"{}\" or \"{}\" and are "
                                        "left out of the curve",
                                        of_curve.without, of_curve.rows, what.x, key));
  for (const std::string& key : what.margin)
    if (const RowsWithout bars = rows_without(table, key, key); bars.without > 0)
      append_sentence(text, fmt::format("{} of {} rows have no number in \"{}\" and no error bar",
                                        bars.without, bars.rows, key));
  return text;
}

std::string left_out_of_map(const Table& table, const TableChart& what) {
  const std::vector<MapPoint> points = map_points(table, what);
  scale_of(points, what);
  const MapAxis x = map_axis(values_of(points, &MapPoint::x), what.x);
  const MapAxis y = map_axis(values_of(points, &MapPoint::y), what.y.front());
  std::set<std::pair<std::int64_t, std::int64_t>> filled;
  std::size_t values = 0;
  for (const MapPoint& p : points)
    if (p.value) {
      filled.insert({x.cell(p.x), y.cell(p.y)});
      ++values;
    }
  std::string text;
  const std::int64_t cells = x.cells() * y.cells();
  if (const std::int64_t blank = cells - static_cast<std::int64_t>(filled.size()); blank > 0)
    text = fmt::format("{} of {} cells have no value in \"{}\" and stay blank", blank, cells,
                       what.value);
  if (values > filled.size())
    append_sentence(text, fmt::format("{} rows lie over rows before them and cover those",
                                      values - filled.size()));
  if (points.size() < table.rows.size())
    append_sentence(text, fmt::format("{} of {} rows have no number in \"{}\" or \"{}\" and are "
                                      "left out",
                                      table.rows.size() - points.size(), table.rows.size(), what.x,
                                      what.y.front()));
  return text;
}

std::string draw_map(PictureFormat format, const Table& table, const TableChart& what, int width,
                     int height) {
  const std::vector<MapPoint> points = map_points(table, what);
  const ParticleColours scale = scale_of(points, what);
  const auto canvas = make_canvas(format, width, height);
  const double unit = height / 560.0;
  const MapAxis x =
      map_axis(values_of(points, &MapPoint::x), what.x, 110.0 * unit, width - 30.0 * unit);
  const MapAxis y =
      map_axis(values_of(points, &MapPoint::y), what.y.front(), height - 130.0 * unit, 50.0 * unit);
  const double wide = x.at(x.step) - x.at(0.0), high = y.at(0.0) - y.at(y.step);
  for (const MapPoint& p : points) {
    if (!p.value)
      continue;
    Style style;
    style.is_filled = true;
    style.fill = scale_colour(scale, *p.value);
    style.line = style.fill; // no seams between neighbours
    style.line_width = 0.5;
    canvas->rectangle({x.at(p.x) - 0.5 * wide, y.at(p.y) - 0.5 * high}, wide, high, style);
  }
  draw_map_axes(*canvas, x, y, what, unit);
  draw_colour_bar(*canvas, {width - 30.0 * unit, height - 60.0 * unit}, scale, unit);
  return canvas->finish();
}

} // namespace ellipsoid::post
