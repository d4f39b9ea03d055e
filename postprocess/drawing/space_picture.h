// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particle_colours.h"
#include "particles.h"
#include "png.h"
#include "run_walls.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

struct SpaceScenery;

struct SpaceView {
  double azimuth_deg = -60.0;     ///< of the camera about z, from x
  double elevation_deg = 25.0;    ///< of the camera over the xy plane
  int width = 1200, height = 900; ///< pixels
  double zoom = 1.0;
  double letters = 1.0;                                 ///< factor on the size of words and lines
  std::array<const char*, 3> axis_names{"x", "y", "z"}; ///< of the upright axes, at the tripod
  bool show_axes = true;                                ///< a tripod in the corner
  bool show_box = false;                                ///< the edges of the particles' box
  std::vector<PrimitivePlane> planes;                   ///< walls, as far as they are seen
  std::vector<std::array<Vector3, 3>> triangles;        ///< of meshes (length)
  std::optional<Box> part; ///< what is fitted into the picture; none: all particles
};

struct SpacePixels {
  PixelImage image;
  double pixels_per_length = 1.0;
  PixelPoint origin{}; ///< where the origin of space is seen (pixels)
};

/// Particles in space as shaded ellipsoids or sub-spheres, parallel projection; z points up.
/// Every visible point is an exact intersection of a pixel's ray with a body (no triangles, no
/// OpenGL, no display); three by three rays per pixel.
/// @param[in] colours one per particle, @param[in] scenery see space_scenery.h, or null
/// Throws InputError when there are no particles.
SpacePixels draw_space(const ParticleSet& upright, const std::vector<Colour>& colours,
                       const SpaceView& view, const SpaceScenery* scenery = nullptr);

/// The same with a heading, a scale bar and, where there is a scale, a colour bar.
/// @return the file's bytes. Throws InputError for PNG in a build without cairo.
std::string space_picture(PictureFormat format, const ParticleSet& upright,
                          const ParticleColours& colours, const SpaceView& view,
                          const std::string& title);

} // namespace ellipsoid::post
