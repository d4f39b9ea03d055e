// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "contacts.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// Statistics of the magnitudes of contact forces, as is usual for force chains.
struct ForceStatistics {
  std::size_t count = 0;
  double mean = 0.0, largest = 0.0; ///< (force)
  double strong_share = 0.0;        ///< forces above the mean, share of the number
  double strong_load_share = 0.0;   ///< the same, share of the sum
  std::vector<double> distribution; ///< density of f / mean in bins 0.25 wide from 0
};

/// Vectors from three named columns; with `to_unit` scaled to length 1 (then zero vectors are an
/// InputError).
std::vector<Vector3> vectors_of(const Frame& frame, const std::vector<std::string>& columns,
                                bool to_unit);

ForceStatistics force_statistics(const std::vector<Vector3>& forces);

/// Names of the columns of a contact list.
struct ContactColumns {
  std::vector<std::string> ids;     ///< of the two particles
  std::vector<std::string> forces;  ///< x y z
  std::vector<std::string> normals; ///< x y z; empty: not listed
  std::vector<std::string> points;  ///< x y z; empty: not listed
  std::string overlap;              ///< empty: not listed
};

/// The contacts of a list as a network: pairs and overlaps (0 where not listed); points and normals
/// are not filled.
/// @param[in] set the particles of the same moment
/// Throws InputError when the list names a particle that is not there.
ContactNetwork listed_contacts(const Frame& list, const ContactColumns& columns,
                               const ParticleSet& set);

/// A link of a force chain: two touching particles and the force between them.
struct ForceLink {
  Vector3 begin, end; ///< the particles' centres, of the second one the nearest image (length)
  double force = 0.0; ///< the normal part, or without normals the magnitude (force)
  std::size_t i = 0, j = 0; ///< the particles, indices of the set
};

/// The links of a contact list; several contacts of one pair (multi-sphere particles) are one link
/// with the sum of their forces. Links without force are left out.
/// @param[in] set the particles of the same moment
/// Throws InputError when the list names a particle that is not there.
std::vector<ForceLink> force_links(const Frame& list, const ContactColumns& columns,
                                   const ParticleSet& set);

} // namespace ellipsoid::post
