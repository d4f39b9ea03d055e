// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "contact_list_options.h"
#include "frame_options.h"
#include "pile_picture.h"
#include "plane_options.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

struct RenderOptions {
  FrameOptions frames;
  PlaneOptions plane;
  PilePictureOptions picture;
  std::vector<double> view, colour_range;
  std::string output;
  bool no_fit = false;
  ContactListOptions contacts;
};

/// Draws the chosen frames of piles in the plane; all frames with one view and one range of
/// colours. Throws InputError. @return exit code
int render_piles(const RenderOptions& options);

} // namespace ellipsoid::post
