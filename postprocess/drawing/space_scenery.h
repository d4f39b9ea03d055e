// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What is drawn around particles in space: walls, meshes, the box. Particles hide what lies behind
// them.
#pragma once

#include "canvas.h"
#include "depth_buffer.h"
#include "space_camera.h"

#include <vector>

namespace ellipsoid::post {

constexpr Colour wall_colour{0.45, 0.47, 0.50};
constexpr double wall_opacity = 0.15;

/// The colour of a line, null for none.
const Colour* colour_of(LineKind kind);

struct SpaceLine {
  Vector3 begin, end; ///< in space (length)
  LineKind kind = LineKind::none;
};

struct SpaceScenery {
  std::vector<std::vector<Vector3>> walls; ///< corners of convex polygons, in space (length)
  std::vector<SpaceLine> lines;
  double line_width = 1.0; ///< pixels
};

/// Plane walls that reach into what is shown or lie close by, as pale rectangles; of meshes the
/// edges of surfaces, folds of more than 20 degrees, and outlines as the camera sees them; the
/// edges of the box, if the view shows it.
/// @param[in] shown part of space, @param[in] unit see legends.h
SpaceScenery scenery_of(const SpaceView& view, const Box& box, const Box& shown, double unit);

/// Adds to each ray what lies in front of the bodies.
void draw_scenery(DepthBuffer& buffer, const Screen& screen, const SpaceScenery& scenery,
                  const Camera& camera);

} // namespace ellipsoid::post
