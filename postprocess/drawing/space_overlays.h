// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What is drawn as lines over a picture of particles in space: axes, box, walls, meshes.
#pragma once

#include "canvas.h"
#include "space_camera.h"

namespace ellipsoid::post {

/// From points in space to a picture's pixels.
class SpaceProjection {
 public:
  /// @param[in] down pixels from the picture's upper edge to that of the particles
  SpaceProjection(const SpaceView& view, const SpacePixels& pixels, double down)
      : m_camera(view),
        m_scale(pixels.pixels_per_length), m_origin{pixels.origin.x, pixels.origin.y + down} {}
  PixelPoint at(const Vector3& v) const {
    const Vector3 p = m_camera.seen(v);
    return {m_origin.x + m_scale * p.x, m_origin.y - m_scale * p.y};
  }

 private:
  Camera m_camera;
  double m_scale;
  PixelPoint m_origin;
};

/// Arrows along x, y and z, the nearest one last. `unit`: see legends.h
void draw_axes(Canvas& canvas, const SpaceView& view, const PixelPoint& corner, double unit);

/// The twelve edges of a box, also of a tilted one.
void draw_box(Canvas& canvas, const SpaceProjection& to, const Box& box, double unit);

/// Plane walls that reach into what is shown or lie close by, as pale rectangles; of meshes the
/// edges of surfaces, folds of more than 20 degrees, and outlines as the camera sees them.
/// @param[in] shown part of space
void draw_surfaces(Canvas& canvas, const SpaceProjection& to, const SpaceView& view,
                   const Box& shown, double unit);

} // namespace ellipsoid::post
