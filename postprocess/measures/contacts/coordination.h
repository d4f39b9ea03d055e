// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "space_walls.h"

#include <optional>
#include <vector>

namespace ellipsoid::post {

struct CoordinationOptions {
  bool count_walls = false;         ///< contacts with wall and floor count as well
  std::vector<SpaceWall> walls;     ///< for count_walls and for the rattlers
  double gap = 0.0;                 ///< bodies this close count as touching (length)
  std::size_t rattler_contacts = 2; ///< fewer contacts (walls included) make a rattler
};

struct Coordination {
  double zpp = 0.0; ///< particle-particle contacts per particle: 2 Ncp / K (paper, 4.2.3)
  double zss = 0.0; ///< sphere-sphere contacts per particle: 2 Ncs / K
  double zpp_without_rattlers = 0.0; ///< over the others, contacts with rattlers left out
  std::size_t particles = 0, pairs = 0, contacts = 0, wall_contacts = 0, rattlers = 0;
  std::vector<std::size_t> distribution; ///< particles with 0, 1, 2 ... touching partners
  double mean_overlap = 0.0, largest_overlap = 0.0; ///< of particle contacts (length)
  std::size_t not_converged = 0;
};

/// Touching partners and walls of every particle of a set.
struct Partners {
  std::vector<std::size_t> particles, walls, wall_bodies;
};
Partners count_partners(const ParticleSet& set, const std::vector<PairContact>& pairs,
                        const CoordinationOptions& options);

/// Coordination numbers and overlaps among the particles `members` of a set.
/// With count_walls each particle that touches a wall counts one more contact per wall.
Coordination coordination(const ParticleSet& set, const std::vector<std::size_t>& members,
                          const ContactNetwork& network, const CoordinationOptions& options);

} // namespace ellipsoid::post
