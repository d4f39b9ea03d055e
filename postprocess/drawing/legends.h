// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What stands below a picture: scale bar and colour bar. `unit` is the size of letters and lines,
// in pixels of a picture 1600 pixels wide.
#pragma once

#include "canvas.h"
#include "particle_colours.h"

namespace ellipsoid::post {

/// A bar of a round length with its value (lengths of the file taken as metres), at most a fifth
/// of `shown_length` long.
/// @param[in] left its left end
void draw_scale_bar(Canvas& canvas, const PixelPoint& left, double pixels_per_length,
                    double shown_length, double unit);

/// The colours of a scale with its ends and its name; its right top corner is at `corner`.
void draw_colour_bar(Canvas& canvas, const PixelPoint& corner, const ParticleColours& colours,
                     double unit);

} // namespace ellipsoid::post
