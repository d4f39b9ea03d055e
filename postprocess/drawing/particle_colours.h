// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "canvas.h"
#include "particles.h"

#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Colours of particles by one of their values.
struct ParticleColours {
  std::vector<Colour> colours; ///< by particle
  bool has_scale = false;      ///< a colour bar makes sense
  bool is_cyclic = false;      ///< angles from 0 to 180 degrees
  std::vector<double> kinds;   ///< values of a column with few whole numbers; empty: a scale
  double low = 0.0, high = 0.0;
  std::string label;
};

/// @param[in] by a column of the frame; "angle" (of the long axis to the space x axis in the
///            xy plane, degrees, 0 to 180); "speed"; empty: one colour for all
/// Throws InputError for an unknown column.
ParticleColours particle_colours(const Frame& frame, const ParticleSet& set, const std::string& by,
                                 const std::optional<double>& low,
                                 const std::optional<double>& high);

/// The colour of a value on a scale.
Colour scale_colour(const ParticleColours& scale, double value);

} // namespace ellipsoid::post
