// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "listed_particles.h"

#include <fmt/format.h>

namespace ellipsoid::post {

ListedParticles::ListedParticles(const Frame& list, const ParticleSet& set) : m_list(list) {
  for (std::size_t k = 0; k < set.particles.size(); ++k)
    m_index_of_id[static_cast<double>(set.particles[k].id)] = k;
}

std::size_t ListedParticles::at(const std::string& column, std::size_t row) const {
  const double id = m_list.required(column, "id of a particle")[row];
  const auto found = m_index_of_id.find(id);
  if (found == m_index_of_id.end())
    throw unexpected({m_list.place.file, m_list.place.line + row, m_list.place.frame},
                     fmt::format("the id of a particle in column \"{}\"", column),
                     fmt::format("{}, which the dump of the particles does not have", id));
  return found->second;
}

} // namespace ellipsoid::post
