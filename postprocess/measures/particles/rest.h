// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

#include <vector>

namespace ellipsoid::post {

/// Is the pile still? Speeds in the units of the file.
struct RestCheck {
  bool is_known = false; ///< the file holds velocities
  bool is_at_rest = false;
  double largest_speed = 0.0; ///< max |v| + a |omega| (length/time)
  double largest_spin = 0.0;  ///< max |omega| (1/time)
  double speed_limit = 0.0;   ///< 0.01 sqrt(g b) (length/time)
};

/// At rest: every point of every member is slower than 0.01 sqrt(g b), a hundredth of the speed
/// of a fall through half the smallest semi-axis.
RestCheck check_rest(const ParticleSet& set, const std::vector<std::size_t>& members,
                     double gravity);

} // namespace ellipsoid::post
