// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "canvas.h"

namespace ellipsoid::post {

/// SVG 1.1 with ellipse, polygon, polyline, text and image elements, nothing else.
class SvgCanvas : public Canvas {
 public:
  SvgCanvas(int width, int height);
  void ellipse(const PixelPoint& centre, double a, double b, double turn_degrees,
               const Style& style) override;
  void polyline(const std::vector<PixelPoint>& points, bool is_closed, const Style& style) override;
  void text(const PixelPoint& position, const std::string& words, const TextStyle& style) override;
  void image(const PixelPoint& corner, const PixelImage& pixels) override;
  void begin_clip(const PixelPoint& corner, double width, double height) override;
  void end_clip() override;
  std::string finish() override;

 private:
  std::string text_;
  int clips_ = 0;
};

} // namespace ellipsoid::post
