// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "paper_figures.h"

#include "csv_table.h"
#include "input_error.h"
#include "multisphere/multisphere_template.h"
#include "paper_values.h"
#include "spread.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>

namespace ellipsoid::post {
namespace {

constexpr Colour blue{0.12, 0.35, 0.70}, orange{0.85, 0.40, 0.05}, green{0.10, 0.50, 0.30},
    violet{0.50, 0.20, 0.60}, dark{0.25, 0.27, 0.30};

std::string text_of(const Row& row, const std::string& key) {
  const Value* value = find_value(row, key);
  const auto* text = value ? std::get_if<std::string>(value) : nullptr;
  return text ? *text : "";
}

/// Number of sub-spheres of all particles of a run (0: smooth), or nothing for mixtures and clumps.
std::optional<int> subspheres_of(const Row& row) {
  const std::string surface = text_of(row, "surface");
  const Value* count = find_value(row, "subspheres");
  double number = 0.0;
  const bool has_count = count && as_number(*count, number);
  if (surface == "smooth")
    return 0;
  if (!has_count || (!surface.empty() && surface != "multisphere"))
    return {};
  return static_cast<int>(number);
}

/// Values of one quantity by number of sub-spheres (0: smooth) over runs with one outline.
std::map<int, Spread> by_subspheres(const Table& runs, const std::string& key,
                                    const std::string& outline) {
  std::map<int, std::vector<double>> values;
  for (const Row& row : runs.rows) {
    const std::string row_outline = text_of(row, "outline");
    const Value* value = find_value(row, key);
    const std::optional<int> subspheres = subspheres_of(row);
    double number = 0.0;
    const bool is_wanted = row_outline.empty() || outline.empty() || row_outline == outline;
    if (is_wanted && subspheres && value && as_number(*value, number))
      values[*subspheres].push_back(number);
  }
  std::map<int, Spread> result;
  for (const auto& [subspheres, numbers] : values)
    result[subspheres] = spread_of(numbers);
  return result;
}

/// The multi-sphere points of a spread by N.
std::vector<ChartPoint> chain_points(const std::map<int, Spread>& spreads) {
  std::vector<ChartPoint> points;
  for (const auto& [subspheres, spread] : spreads)
    if (subspheres > 0)
      points.push_back({static_cast<double>(subspheres), spread.mean, spread.half_range});
  return points;
}

Series series(std::string name, std::vector<ChartPoint> points, const Colour& colour,
              Marker marker) {
  Series result;
  result.name = std::move(name);
  result.points = std::move(points);
  result.colour = colour;
  result.marker = marker;
  return result;
}

/// The name of a band in the legend.
std::string with_margin_named(const std::string& name, double margin) {
  return margin > 0.0 ? name + " ± half range" : name;
}

/// Adds the paper's values: its multi-sphere points open, its ellipse as a dashed band.
void add_paper(Chart& chart, const std::vector<paper::Reported>& values) {
  std::vector<ChartPoint> points;
  for (const auto& reported : values) {
    if (reported.subspheres > 0)
      points.push_back({static_cast<double>(reported.subspheres), reported.value, reported.margin});
    else
      chart.bands.push_back({with_margin_named("ellipse (paper)", reported.margin), reported.value,
                             reported.margin, orange, true});
  }
  if (points.empty())
    return;
  Series reported = series("MS (paper)", std::move(points), orange, Marker::square);
  reported.is_joined = false;
  reported.is_filled = false;
  chart.series.push_back(std::move(reported));
}

/// A quantity over N: ours, the paper's, both ellipses as bands.
Chart over_subspheres(const Table& runs, const std::string& key, const std::string& title,
                      const std::string& label, const std::vector<paper::Reported>& reported) {
  Chart chart;
  chart.title = title;
  chart.x_label = "number of sub-spheres N";
  chart.y_label = label;
  chart.x_ticks = {1, 3, 5, 7, 9, 11, 13, 15, 17};
  const auto spreads = by_subspheres(runs, key, "true");
  if (spreads.empty())
    throw InputError(fmt::format("figure \"{}\": expected CSV files with a column \"{}\" and "
                                 "\"subspheres\" (or \"surface\" that says smooth), {}",
                                 title, key, columns_found(runs)));
  if (const auto points = chain_points(spreads); !points.empty())
    chart.series.push_back(series("MS (this work)", points, blue, Marker::circle));
  if (const auto smooth = spreads.find(0); smooth != spreads.end())
    chart.bands.push_back({with_margin_named("ellipse (this work)", smooth->second.half_range),
                           smooth->second.mean, smooth->second.half_range, blue, false});
  add_paper(chart, reported);
  double largest = 17.0;
  for (const auto& [subspheres, spread] : spreads)
    largest = std::max(largest, static_cast<double>(subspheres));
  if (largest > 17.0)
    chart.x_ticks.clear();
  else if (spreads.count(1) == 0 && std::none_of(reported.begin(), reported.end(),
                                                 [](auto& r) { return r.subspheres == 1; }))
    chart.x_ticks.erase(chart.x_ticks.begin());
  return chart;
}

constexpr int largest_in_figure_5 = 55; ///< sub-spheres; the finest chain of figure 4

/// Ratios of a template's measures to the ellipse's over N for one aspect ratio.
Series template_ratio(double aspect, double MultisphereMeasures::*ratio, const Colour& colour,
                      Marker marker) {
  Series result = series(fmt::format("s = {:g}", aspect), {}, colour, marker);
  for (int count = 3; count <= largest_in_figure_5; count += 2) {
    if (count > 3 && count < smallest_overlapping_count(aspect))
      continue;
    if (count == 3 && aspect > 3.0) // N = 3 exists up to a = 3 b
      continue;
    result.points.push_back(
        {static_cast<double>(count), measure(make_multisphere(aspect, 1.0, count)).*ratio, 0.0});
  }
  return result;
}

std::vector<Chart> figure_5() {
  Chart area, perimeter;
  area.title = "5a. Section area of the templates";
  area.y_label = "A_{MS} / A_{ell}";
  perimeter.title = "5b. Perimeter of the templates";
  perimeter.y_label = "P_{MS} / P_{ell}";
  area.x_label = perimeter.x_label = "number of sub-spheres N";
  const std::vector<std::pair<double, Colour>> aspects = {
      {1.5, blue}, {2.35, orange}, {5.0, green}, {10.0, violet}};
  const Marker markers[] = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond};
  for (std::size_t k = 0; k < aspects.size(); ++k) {
    const auto& [aspect, colour] = aspects[k];
    area.series.push_back(
        template_ratio(aspect, &MultisphereMeasures::area_ratio, colour, markers[k]));
    perimeter.series.push_back(
        template_ratio(aspect, &MultisphereMeasures::perimeter_ratio, colour, markers[k]));
  }
  area.x_ticks = perimeter.x_ticks = {3, 7, 11, 15, 19, 23, 27, 31, 35, 39, 43, 47, 51, 55};
  Series reported = series("paper: N = 13 at s = 2.35", {{13.0, 0.99, 0.0}}, dark, Marker::square);
  reported.is_joined = false;
  reported.is_filled = false;
  area.series.push_back(std::move(reported));
  area.bands.push_back({"1 % below the ellipse", 0.99, 0.0, dark, true});
  return {area, perimeter};
}

std::vector<Chart> figure_13(const Table& runs) {
  Chart porosity = over_subspheres(runs, "porosity", "13a. Porosity", "porosity", paper::porosity);
  const auto ellipses = chain_points(by_subspheres(runs, "porosity", "ellipse"));
  if (!ellipses.empty() && std::any_of(runs.rows.begin(), runs.rows.end(), [](const Row& row) {
        return text_of(row, "outline") == "ellipse";
      }))
    porosity.series.push_back(series("MS ellipse (this work)", ellipses, green, Marker::triangle));
  Chart coordination = over_subspheres(runs, "zpp", "13b. Coordination number",
                                       "contacts per particle", paper::coordination);
  if (const auto zss = chain_points(by_subspheres(runs, "zss", "true")); !zss.empty())
    coordination.series.push_back(
        series("sphere-sphere (this work)", zss, violet, Marker::diamond));
  return {porosity, coordination};
}

/// A quantity relative to the smooth ellipse's over a shape factor of the templates.
Series over_shape_factor(const Table& runs, const std::string& key, double aspect,
                         double MultisphereMeasures::*factor, const std::string& name,
                         const Colour& colour, Marker marker) {
  const auto spreads = by_subspheres(runs, key, "true");
  const auto smooth = spreads.find(0);
  if (smooth == spreads.end() || smooth->second.mean == 0.0)
    throw InputError("figure 15 needs rows of smooth runs: they are the reference");
  Series result = series(name, {}, colour, marker);
  for (const auto& [subspheres, spread] : spreads)
    if (subspheres > 1)
      result.points.push_back({measure(make_multisphere(aspect, 1.0, subspheres)).*factor,
                               spread.mean / smooth->second.mean,
                               spread.half_range / smooth->second.mean});
  std::sort(result.points.begin(), result.points.end(),
            [](const ChartPoint& p, const ChartPoint& q) { return p.x < q.x; });
  return result;
}

/// The paper's values relative to its ellipse over the area shape factor.
Series reported_over_shape_factor(const std::vector<paper::Reported>& values, double aspect) {
  Series result = series("paper, area (26)", {}, dark, Marker::triangle);
  result.is_joined = false;
  result.is_filled = false;
  for (const auto& reported : values) // the first one is the ellipse
    if (reported.subspheres > 1)
      result.points.push_back(
          {measure(make_multisphere(aspect, 1.0, reported.subspheres)).area_shape_factor,
           reported.value / values.front().value, 0.0});
  return result;
}

std::vector<Chart> figure_15(const Table& runs, double aspect) {
  std::vector<Chart> charts(2);
  const std::vector<std::string> keys = {"repose_angle_deg", "porosity"};
  charts[0].title = "15a. Angle of repose and shape factors";
  charts[0].y_label = "angle / angle of the ellipse";
  charts[1].title = "15b. Porosity and shape factors";
  charts[1].y_label = "porosity / porosity of the ellipse";
  for (std::size_t k = 0; k < 2; ++k) {
    charts[k].x_label = "shape factor";
    charts[k].series = {
        over_shape_factor(runs, keys[k], aspect, &MultisphereMeasures::area_shape_factor,
                          "area (26)", blue, Marker::circle),
        over_shape_factor(runs, keys[k], aspect, &MultisphereMeasures::perimeter_shape_factor,
                          "perimeter (27)", orange, Marker::square)};
    charts[k].series.push_back(
        reported_over_shape_factor(k == 0 ? paper::repose_angle : paper::porosity, aspect));
    charts[k].bands.push_back({"ellipse", 1.0, 0.0, dark, true});
  }
  return charts;
}

} // namespace

const std::vector<int> known_figures = {5, 12, 13, 15, 17, 18};

const std::vector<std::string> figure_columns = {"repose_angle_deg",
                                                 "porosity",
                                                 "zpp",
                                                 "zss",
                                                 "relative_cpu_time",
                                                 "potential_contacts_per_particle"};

Table drawn_in_figures(const Table& runs) {
  Table drawn{runs.title, {}};
  std::copy_if(runs.rows.begin(), runs.rows.end(), std::back_inserter(drawn.rows),
               [](const Row& row) { return subspheres_of(row).has_value(); });
  return drawn;
}

namespace {

/// Mixtures and clumps, by name; or nothing.
std::string of_no_figure(const Table& runs) {
  std::string names;
  std::size_t count = 0;
  for (const Row& row : runs.rows)
    if (!subspheres_of(row)) {
      const Value* run = find_value(row, "run");
      names += (names.empty() ? "" : ", ") + (run ? shown(*run) : "a row without a name");
      ++count;
    }
  if (count == 0)
    return "";
  return fmt::format("{} of {} runs {} not in the figures, which are of ellipsoids with one number "
                     "N of sub-spheres (mixtures and clumps are not): {}",
                     count, runs.rows.size(), count == 1 ? "is" : "are", names);
}

/// Columns that a figure draws.
std::vector<std::string> drawn_columns(int figure) {
  static const std::map<int, std::vector<std::string>> columns = {
      {12, {"repose_angle_deg"}},
      {13, {"porosity", "zpp", "zss"}},
      {15, {"repose_angle_deg", "porosity"}},
      {17, {"relative_cpu_time"}},
      {18, {"potential_contacts_per_particle"}}};
  const auto found = columns.find(figure);
  return found == columns.end() ? std::vector<std::string>() : found->second;
}

} // namespace

std::string left_out_of_figures(const Table& runs, const std::vector<int>& figures) {
  std::string text = of_no_figure(runs);
  const Table drawn = drawn_in_figures(runs);
  std::set<std::string> keys;
  for (const int number : figures)
    for (const std::string& key : drawn_columns(number))
      keys.insert(key);
  for (const Quantity& column : drawn.header())
    if (keys.count(column.key) > 0)
      if (const std::string words = runs_without_number(drawn, column.key); !words.empty())
        text += (text.empty() ? "" : "; ") + words;
  return text;
}

Table compared_with_paper(const Table& runs) {
  struct Compared {
    std::string key, name, unit;
    const std::vector<paper::Reported>& reported;
  };
  const std::vector<Compared> quantities = {
      {"repose_angle_deg", "angle of repose", "deg", paper::repose_angle},
      {"porosity", "porosity", "", paper::porosity},
      {"zpp", "coordination number", "", paper::coordination}};
  const auto with_margin = [](double value, double margin) {
    return margin > 0.0 ? fmt::format("{:.4g} +- {:.2g}", value, margin)
                        : fmt::format("{:.4g}", value);
  };
  Table table{"Compared with the paper", {}};
  for (const Compared& q : quantities) {
    const auto ours = by_subspheres(runs, q.key, "true");
    for (const paper::Reported& r : q.reported)
      if (const auto found = ours.find(r.subspheres); found != ours.end()) {
        const Spread& s = found->second;
        const std::string shape =
            r.subspheres > 0 ? fmt::format("N = {}", r.subspheres) : "ellipse";
        table.rows.push_back(
            {{"quantity", "quantity", "", q.name + (q.unit.empty() ? "" : " [" + q.unit + "]")},
             {"shape", "particles", "", shape},
             {"paper", "paper", "", with_margin(r.value, r.margin)},
             {"here", "here", "", with_margin(s.mean, s.half_range)},
             {"runs", "runs", "", static_cast<std::int64_t>(s.count)},
             {"difference_percent", "difference", "%",
              fmt::format("{:+.1f}", 100.0 * (s.mean / r.value - 1.0))}});
      }
  }
  return table;
}

namespace {

/// Takes the paper's values out of a chart.
void hide_paper(Chart& chart) {
  const auto is_of_paper = [](const auto& drawn) {
    return drawn.name.find("(paper)") != std::string::npos || drawn.name.rfind("paper", 0) == 0;
  };
  chart.series.erase(std::remove_if(chart.series.begin(), chart.series.end(), is_of_paper),
                     chart.series.end());
  chart.bands.erase(std::remove_if(chart.bands.begin(), chart.bands.end(), is_of_paper),
                    chart.bands.end());
}

std::vector<Chart> whole_figure(int number, const Table& runs, double aspect_ratio) {
  switch (number) {
  case 5:
    return figure_5();
  case 12:
    return {over_subspheres(runs, "repose_angle_deg", "12. Angle of repose",
                            "angle of repose [deg]", paper::repose_angle)};
  case 13:
    return figure_13(runs);
  case 15:
    return figure_15(runs, aspect_ratio);
  case 17:
    return {over_subspheres(runs, "relative_cpu_time", "17. CPU time relative to spheres",
                            "CPU time / CPU time of spheres", paper::relative_cpu_time)};
  case 18:
    return {over_subspheres(runs, "potential_contacts_per_particle", "18. Potential contacts",
                            "potential contacts per particle", paper::potential_contacts)};
  default:
    throw InputError(fmt::format("figure {}: known are 5, 12, 13, 15, 17, 18", number));
  }
}

} // namespace

std::vector<Chart> figure(int number, const Table& runs, double aspect_ratio, PaperPoints points) {
  std::vector<Chart> charts = whole_figure(number, runs, aspect_ratio);
  if (points == PaperPoints::hidden)
    for (Chart& chart : charts)
      hide_paper(chart);
  return charts;
}

} // namespace ellipsoid::post
