// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "canvas.h"
#include "particles.h"
#include "png.h"

#include <vector>

namespace ellipsoid::post {

struct SpaceView {
  double azimuth_deg = -60.0;     ///< of the camera about z, from x
  double elevation_deg = 25.0;    ///< of the camera over the xy plane
  int width = 1200, height = 900; ///< pixels
  double zoom = 1.0;
};

/// Particles in space as shaded ellipsoids or sub-spheres, parallel projection; z points up.
/// Every visible point is an exact intersection of a pixel's ray with a body (no triangles, no
/// OpenGL, no display); three by three rays per pixel.
/// @param[in] colours one per particle
/// Throws InputError when there are no particles.
PixelImage draw_space(const ParticleSet& upright, const std::vector<Colour>& colours,
                      const SpaceView& view);

} // namespace ellipsoid::post
