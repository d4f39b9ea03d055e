// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "space_picture.h"

#include <cmath>

namespace ellipsoid::post {

/// Axes of the camera's frame: x to the right, y up, z towards the camera.
struct Camera {
  Vector3 right, up, towards;

  explicit Camera(const SpaceView& view) {
    constexpr double radians = 3.141592653589793238462643 / 180.0;
    const double azimuth = view.azimuth_deg * radians, elevation = view.elevation_deg * radians;
    towards = {std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation),
               std::sin(elevation)};
    right = {-std::sin(azimuth), std::cos(azimuth), 0.0};
    up = cross(towards, right);
  }
  Vector3 seen(const Vector3& v) const { return {dot(right, v), dot(up, v), dot(towards, v)}; }
};

} // namespace ellipsoid::post
