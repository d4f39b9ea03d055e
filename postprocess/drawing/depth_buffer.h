// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What is seen along each ray of a picture in space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ellipsoid::post {

constexpr int rays_per_side = 3; ///< of a pixel

/// What a line in space stands for.
enum class LineKind : std::uint8_t { none, wall, box, mesh };

/// The nearest body behind each ray, and what lies in front of it.
struct DepthBuffer {
  std::size_t width = 0, height = 0;
  std::vector<double> depth; ///< towards the camera (length)
  std::vector<std::int32_t> owner;
  std::vector<float> light;        ///< from 0 to 1
  std::vector<std::uint8_t> walls; ///< how many
  std::vector<LineKind> lines;

  DepthBuffer(std::size_t w, std::size_t h)
      : width(w), height(h), depth(w * h, -std::numeric_limits<double>::infinity()),
        owner(w * h, -1), light(w * h, 0.0f), walls(w * h, 0), lines(w * h, LineKind::none) {}
};

/// Camera coordinates to rays.
struct Screen {
  double left = 0.0, top = 0.0, scale = 1.0; ///< scale: rays per length
  double x(std::size_t i) const { return left + (static_cast<double>(i) + 0.5) / scale; }
  double y(std::size_t j) const { return top - (static_cast<double>(j) + 0.5) / scale; }
};

} // namespace ellipsoid::post
