// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "canvas.h"
#include "space_picture.h"

namespace ellipsoid::post {

/// Arrows along x, y and z, the nearest one last. `unit`: see legends.h
void draw_axes(Canvas& canvas, const SpaceView& view, const PixelPoint& corner, double unit);

} // namespace ellipsoid::post
