// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "canvas.h"

#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

enum class Marker { circle, square, triangle, diamond, none };

/// A measured or reported value with its margin.
struct ChartPoint {
  double x = 0.0, y = 0.0, margin = 0.0;
};

struct Series {
  std::string name;
  std::vector<ChartPoint> points;
  Colour colour{};
  Marker marker = Marker::circle;
  bool is_joined = true; ///< a line through the points
  bool is_filled = true; ///< filled markers: ours; open ones: the paper's
  bool is_dashed = false;
};

/// A horizontal line y with a band y +- margin, as the smooth ellipse in the paper's figures.
struct Band {
  std::string name;
  double y = 0.0, margin = 0.0;
  Colour colour{};
  bool is_dashed = false;
};

struct Chart {
  std::string title, x_label, y_label;
  std::vector<Series> series;
  std::vector<Band> bands;
  std::optional<double> y_low, y_high; ///< none: of the data
  std::vector<double> x_ticks;         ///< empty: round numbers
};

/// Draws charts side by side.
/// @return the file's bytes. Throws InputError when a chart has nothing to show.
std::string draw_charts(PictureFormat format, const std::vector<Chart>& charts, int width,
                        int height);

} // namespace ellipsoid::post
