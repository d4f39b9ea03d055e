// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "listed_particles.h"

#include <fmt/format.h>

namespace ellipsoid::post {

ListedParticles::ListedParticles(const Frame& list, const ParticleSet& set) : list_(list) {
  for (std::size_t k = 0; k < set.particles.size(); ++k) {
    const Particle& p = set.particles[k];
    if (!p.is_host_body)
      index_of_id_[static_cast<double>(p.id)] = k;
    else // the host's lists name its spheres
      for (std::size_t s = p.first_sphere; s < p.first_sphere + p.sphere_count; ++s)
        index_of_id_[static_cast<double>(set.sphere_ids[s])] = k;
  }
}

std::size_t ListedParticles::at(const std::string& column, std::size_t row) const {
  const double id = list_.required(column, "id of a particle")[row];
  const auto found = index_of_id_.find(id);
  if (found == index_of_id_.end())
    throw unexpected({list_.location.file, list_.location.line + row, list_.location.frame},
                     fmt::format("the id of a particle in column \"{}\"", column),
                     fmt::format("{}, which the dump of the particles does not have", id));
  return found->second;
}

ListedVectors::ListedVectors(const Frame& list, const std::vector<std::string>& names,
                             const std::string& purpose) {
  if (!names.empty())
    columns_ = {&list.required(names.at(0), purpose), &list.required(names.at(1), purpose),
                &list.required(names.at(2), purpose)};
}

std::optional<Vector3> ListedVectors::at(std::size_t row) const {
  if (!columns_)
    return {};
  return columns_.at(row);
}

} // namespace ellipsoid::post
