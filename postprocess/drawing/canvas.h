// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Plane drawings with two ways out: SVG (always) and PNG (where cairo is there).
// Coordinates in pixels, x to the right, y downwards, as in SVG.
#pragma once

#include "png.h"

#include <memory>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Red, green, blue from 0 to 1.
struct Colour {
  double red = 0.0, green = 0.0, blue = 0.0;
};

struct PixelPoint {
  double x = 0.0, y = 0.0;
};

/// How a shape is drawn; a width of 0 means no line.
struct Style {
  bool is_filled = false;
  Colour fill{};
  double fill_opacity = 1.0;
  double line_width = 1.0; ///< pixels
  Colour line{};
  std::vector<double> dashes = {}; ///< lengths of strokes and gaps (pixels)
};

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 14.0; ///< pixels
  Anchor anchor = Anchor::start;
  Colour colour{};
  bool is_bold = false;
  double turn_degrees = 0.0; ///< clockwise about the anchor point
};

class Canvas {
 public:
  virtual ~Canvas() = default;
  /// Ellipse with semi-axes `a`, `b`, the first turned clockwise from x by `turn_degrees`.
  virtual void ellipse(const PixelPoint& centre, double a, double b, double turn_degrees,
                       const Style& style) = 0;
  virtual void polyline(const std::vector<PixelPoint>& points, bool is_closed,
                        const Style& style) = 0;
  /// Text in UTF-8 on a baseline at `position`.
  virtual void text(const PixelPoint& position, const std::string& words,
                    const TextStyle& style) = 0;
  /// A picture of pixels, one to one, its left top corner at `corner`.
  virtual void image(const PixelPoint& corner, const PixelImage& pixels) = 0;
  /// Restricts what follows to a rectangle, until `end_clip`.
  virtual void begin_clip(const PixelPoint& corner, double width, double height) = 0;
  virtual void end_clip() = 0;
  /// The finished file's bytes.
  virtual std::string finish() = 0;

  void line(const PixelPoint& from, const PixelPoint& to, const Style& style) {
    polyline({from, to}, false, style);
  }
  void rectangle(const PixelPoint& corner, double width, double height, const Style& style) {
    polyline({corner,
              {corner.x + width, corner.y},
              {corner.x + width, corner.y + height},
              {corner.x, corner.y + height}},
             true, style);
  }
};

/// A stretch of a text; "A_{MS}" is "A" with the subscript "MS".
struct TextPart {
  std::string words;
  bool is_subscript = false;
};
std::vector<TextPart> text_parts(const std::string& words);
/// Size and depth of a subscript as shares of the text's size.
constexpr double subscript_size = 0.7, subscript_depth = 0.25;

enum class PictureFormat { svg, png };

/// By the ending of a file name (.svg, .png). Throws InputError for any other.
PictureFormat picture_format(const std::string& path);

/// Whether this build has cairo.
bool draws_png();

/// A white canvas. Throws InputError for PNG in a build without cairo.
std::unique_ptr<Canvas> make_canvas(PictureFormat format, int width, int height);

} // namespace ellipsoid::post
