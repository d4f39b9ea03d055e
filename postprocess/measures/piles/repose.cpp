// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "repose.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

constexpr double degrees = 180.0 / 3.141592653589793238462643;

/// Columns of the free surface from the pile's middle (summit or wall) outwards.
std::vector<Point> flank_columns(const Pile& pile, const PileOptions& options, Flank flank) {
  const double spacing = options.column_spacing * pile.mean_b;
  const double begin = options.wall ? pile.left : pile.surface.summit().x();
  const double end = flank == Flank::right ? pile.right : pile.left;
  const double direction = flank == Flank::right ? 1.0 : -1.0;
  const double length = direction * (end - begin);
  constexpr double most_columns = 1.0e7;
  if (!(length <= most_columns * spacing))
    throw InputError(fmt::format("the free surface would need {:.3g} columns (at most {:.0g}): the "
                                 "particles' sizes differ too much, choose a larger --columns",
                                 length / spacing, most_columns));
  std::vector<double> abscissas;
  for (std::size_t k = 0; (static_cast<double>(k) + 0.5) * spacing < length; ++k)
    abscissas.push_back(begin + direction * (static_cast<double>(k) + 0.5) * spacing);
  if (flank == Flank::left)
    std::reverse(abscissas.begin(), abscissas.end());
  const std::vector<double> heights = pile.surface.heights(abscissas);
  std::vector<Point> columns(abscissas.size());
  for (std::size_t k = 0; k < columns.size(); ++k)
    columns[k] = {abscissas[k], heights[k]};
  if (flank == Flank::left)
    std::reverse(columns.begin(), columns.end());
  return columns;
}

/// Heights of the columns, each averaged over `reach` columns to both sides (as far as there are).
std::vector<double> smoothed(const std::vector<Point>& columns, std::size_t reach) {
  std::vector<double> sums(columns.size() + 1, 0.0);
  for (std::size_t k = 0; k < columns.size(); ++k)
    sums[k + 1] = sums[k] + columns[k].y();
  std::vector<double> means(columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::size_t first = k > reach ? k - reach : 0;
    const std::size_t last = std::min(columns.size(), k + reach + 1);
    means[k] = (sums[last] - sums[first]) / static_cast<double>(last - first);
  }
  return means;
}

/// Columns from A to B.
struct Segment {
  std::size_t first = 0, end = 0;
};

Segment middle_segment(const std::vector<Point>& columns, const Pile& pile,
                       const PileOptions& options) {
  if (columns.empty())
    return {};
  const double reach = pile.mean_a / (options.column_spacing * pile.mean_b);
  const std::vector<double> heights = smoothed(columns, static_cast<std::size_t>(reach));
  const auto top = std::max_element(heights.begin(), heights.end());
  const double height = *top - options.floor;
  const auto first_below = [&](std::vector<double>::const_iterator from, double share) {
    return std::find_if(from, heights.cend(),
                        [&](double y) { return y < options.floor + share * height; });
  };
  const auto a = first_below(top, 1.0 - options.cut_top);
  const auto b = first_below(a, options.cut_bottom);
  return {static_cast<std::size_t>(a - heights.cbegin()),
          static_cast<std::size_t>(b - heights.cbegin())};
}

} // namespace

LineFit fit_line(const std::vector<Point>& points) {
  const auto n = static_cast<double>(points.size());
  Point mean(0.0, 0.0);
  for (const Point& p : points)
    mean += p;
  mean /= n;
  double sxx = 0.0, sxy = 0.0;
  for (const Point& p : points) {
    sxx += (p.x() - mean.x()) * (p.x() - mean.x());
    sxy += (p.x() - mean.x()) * (p.y() - mean.y());
  }
  LineFit fit;
  fit.slope = sxy / sxx;
  fit.intercept = mean.y() - fit.slope * mean.x();
  double squares = 0.0;
  for (const Point& p : points) {
    const double r = p.y() - fit.intercept - fit.slope * p.x();
    squares += r * r;
  }
  fit.residual = std::sqrt(squares / n);
  fit.slope_error = n > 2.0 ? std::sqrt(squares / (n - 2.0) / sxx) : 0.0;
  return fit;
}

ReposeAngle repose_angle(const Pile& pile, const PileOptions& options, Flank flank) {
  const std::vector<Point> columns = flank_columns(pile, options, flank);
  const auto [first, end] = middle_segment(columns, pile, options);
  if (end < first + 3)
    throw InputError(
        fmt::format("the free surface has {} columns between A and B, at least 3 are "
                    "needed: the pile is too small, or lower --cut-bottom and --cut-top",
                    end - first));
  const std::vector<Point> segment(columns.begin() + static_cast<std::ptrdiff_t>(first),
                                   columns.begin() + static_cast<std::ptrdiff_t>(end));
  ReposeAngle result;
  result.line = fit_line(segment);
  result.columns = segment.size();
  const double downhill = flank == Flank::right ? -result.line.slope : result.line.slope;
  result.angle_deg = degrees * std::atan(downhill);
  const double length = std::abs(segment.back().x() - segment.front().x());
  const double samples = static_cast<double>(segment.size());
  const double independent = std::clamp(length / (2.0 * pile.mean_a), 1.0, samples);
  const double slope_error = result.line.slope_error * std::sqrt(samples / independent);
  result.standard_error_deg = degrees * slope_error / (1.0 + downhill * downhill);
  result.residual = result.line.residual;
  result.residual_in_b = result.residual / pile.mean_b;
  const auto on_line = [&](double x) {
    return Point(x, result.line.intercept + result.line.slope * x);
  };
  result.a = on_line(segment.front().x());
  result.b = on_line(segment.back().x());
  return result;
}

} // namespace ellipsoid::post
