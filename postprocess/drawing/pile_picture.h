// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "canvas.h"
#include "contact_forces.h"
#include "particles.h"
#include "pile.h"
#include "repose.h"

#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

struct PileView {
  double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0; ///< shown part of the plane (length)
};

/// What is shown of a pile where nothing else is asked for: all of it, and what lies near it.
PileView whole_pile(const ParticleSet& set, const Pile& pile, const PileOptions& options);

struct PilePictureOptions {
  int width = 1600;                              ///< pixels; the height follows from the view
  double letters = 1.0;                          ///< factor on the size of words and lines
  std::string colour_by;                         ///< column, "angle", "speed"; empty: one colour
  std::optional<double> colour_low, colour_high; ///< ends of the colour scale; none: of the data
  std::optional<PileView> view;                  ///< none: the whole pile
  bool show_fit = true;                          ///< the line A-B and the angle
  bool show_surface = false;                     ///< the free surface y_max(x)
  bool show_discs = false;                       ///< inner outlines of the sub-spheres
  std::vector<ForceLink> force_chains;           ///< drawn over pale particles; empty: none
  std::string title;
};

/// Draws an in-plane pile with wall, floor, fitted lines and scale bar (paper, figures 10, 11, 14).
/// Throws InputError for unknown columns.
/// @return the file's bytes
std::string draw_pile(PictureFormat format, const Frame& frame, const ParticleSet& set,
                      const Pile& pile, const PileOptions& pile_options,
                      const std::vector<ReposeAngle>& flanks, const PilePictureOptions& options);

} // namespace ellipsoid::post
