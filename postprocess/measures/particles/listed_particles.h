// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

#include <optional>
#include <string>
#include <unordered_map>

namespace ellipsoid::post {

/// The particles that a list of contacts names by their ids.
class ListedParticles {
 public:
  /// @param[in] list and the particles of the same moment; both must outlive it
  ListedParticles(const Frame& list, const ParticleSet& set);
  /// Index of the particle named in a row. Throws InputError for one that is not there.
  std::size_t at(const std::string& column, std::size_t row) const;

 private:
  const Frame& list_;
  std::unordered_map<double, std::size_t> index_of_id_;
};

/// Three columns of a list as vectors; none where they are not named.
class ListedVectors {
 public:
  ListedVectors(const Frame& list, const std::vector<std::string>& names,
                const std::string& purpose);
  std::optional<Vector3> at(std::size_t row) const;

 private:
  VectorColumns columns_;
};

} // namespace ellipsoid::post
