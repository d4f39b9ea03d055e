// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "fields.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// Names of the columns of a list of contacts with forces; empty: not listed.
struct ForceColumns {
  std::vector<std::string> ids;     ///< of the two particles; at walls of the one
  std::vector<std::string> points;  ///< x y z
  std::vector<std::string> forces;  ///< x y z, on the first particle
  std::vector<std::string> normals; ///< x y z
};

/// The contacts of a list.
/// @param[in] set the particles of the same moment
/// Throws InputError for missing columns, and for a particle that is not there.
std::vector<ForceContact> force_contacts(const Frame& list, const ForceColumns& columns,
                                         const ParticleSet& set);

/// Whether the forces, all together, pull the particles to their contacts: then they are those on
/// the other side.
bool forces_pull(const std::vector<ForceContact>& contacts, const ParticleSet& set,
                 const PeriodicCell& cell);

} // namespace ellipsoid::post
