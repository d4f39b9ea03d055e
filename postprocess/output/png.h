// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// A picture of 8-bit red, green, blue samples, row by row from the top.
struct PixelImage {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> samples; ///< 3 width height values
};

/// The PNG file of a picture; needs zlib only.
std::string png_bytes(const PixelImage& image);

} // namespace ellipsoid::post
