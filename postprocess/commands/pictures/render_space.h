// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_options.h"
#include "run_surfaces.h"
#include "space_picture.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

struct RenderSpaceOptions {
  FrameOptions frames;
  SpaceView view;
  std::string up, colour_by, output, title;
  std::vector<double> colour_range, part;
  RunSurfaceOptions surfaces;
  bool is_bare = false, show_walls = false;
};

/// Draws the chosen frames of particles in space; all frames with one view and one range of
/// colours. Throws InputError. @return exit code
int render_spaces(const RenderSpaceOptions& options);

} // namespace ellipsoid::post
