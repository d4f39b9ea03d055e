// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "canvas.h"

#include <cairo.h>

namespace ellipsoid::post {

/// PNG by cairo's image surface: no display, no OpenGL.
class CairoCanvas : public Canvas {
 public:
  CairoCanvas(int width, int height);
  ~CairoCanvas() override;
  CairoCanvas(const CairoCanvas&) = delete;
  CairoCanvas& operator=(const CairoCanvas&) = delete;

  void ellipse(const PixelPoint& centre, double a, double b, double turn_degrees,
               const Style& style) override;
  void polyline(const std::vector<PixelPoint>& points, bool is_closed, const Style& style) override;
  void text(const PixelPoint& position, const std::string& words, const TextStyle& style) override;
  void image(const PixelPoint& corner, const PixelImage& pixels) override;
  void begin_clip(const PixelPoint& corner, double width, double height) override;
  void end_clip() override;
  std::string finish() override;

 private:
  void paint(const Style& style);

  cairo_surface_t* surface_;
  cairo_t* cairo_;
};

} // namespace ellipsoid::post
