// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contact_forces.h"

#include "listed_particles.h"
#include "particle_columns.h"
#include "periodic_cell.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace ellipsoid::post {

std::vector<Vector3> vectors_of(const Frame& frame, const std::vector<std::string>& columns,
                                bool to_unit) {
  const auto& x = frame.required(columns.at(0), "first component");
  const auto& y = frame.required(columns.at(1), "second component");
  const auto& z = frame.required(columns.at(2), "third component");
  std::vector<Vector3> vectors;
  for (std::size_t row = 0; row < frame.rows; ++row) {
    const Vector3 v{x[row], y[row], z[row]};
    const double length = norm(v);
    if (to_unit && !(length > 0.0))
      throw bad_value(frame, row,
                      fmt::format("a direction in the columns \"{}\" \"{}\" \"{}\"", columns.at(0),
                                  columns.at(1), columns.at(2)),
                      "one of length 0");
    vectors.push_back(to_unit ? (1.0 / length) * v : v);
  }
  return vectors;
}

ForceStatistics force_statistics(const std::vector<Vector3>& forces) {
  constexpr double bin_width = 0.25;
  constexpr std::size_t bins = 24; // up to six times the mean
  ForceStatistics result;
  result.count = forces.size();
  result.distribution.assign(bins, 0.0);
  const double count = static_cast<double>(std::max<std::size_t>(1, forces.size()));
  for (const Vector3& f : forces) {
    result.mean += norm(f) / count;
    result.largest = std::max(result.largest, norm(f));
  }
  if (!(result.mean > 0.0))
    return result;
  for (const Vector3& f : forces) {
    const double share = norm(f) / result.mean;
    const auto bin = static_cast<std::size_t>(share / bin_width);
    if (bin < bins)
      result.distribution[bin] += 1.0 / (count * bin_width);
    if (share > 1.0) {
      result.strong_share += 1.0 / count;
      result.strong_load_share += share / count;
    }
  }
  return result;
}

namespace {

/// Force of each row of a list: its part along the normal, or its magnitude.
std::vector<double> row_forces(const Frame& list, const ContactColumns& columns) {
  std::vector<double> result;
  for (const Vector3& force : vectors_of(list, columns.forces, false))
    result.push_back(norm(force));
  if (columns.normals.empty())
    return result;
  const auto forces = vectors_of(list, columns.forces, false);
  const auto normals = vectors_of(list, columns.normals, true);
  for (std::size_t row = 0; row < result.size(); ++row)
    result[row] = std::abs(dot(forces[row], normals[row]));
  return result;
}

using Pair = std::pair<std::size_t, std::size_t>; ///< indices, the smaller first

/// The two particles of each row of a list.
std::vector<Pair> row_pairs(const Frame& list, const ContactColumns& columns,
                            const ParticleSet& set) {
  const ListedParticles particles(list, set);
  std::vector<Pair> pairs;
  for (std::size_t row = 0; row < list.rows; ++row)
    pairs.push_back(
        std::minmax({particles.at(columns.ids.at(0), row), particles.at(columns.ids.at(1), row)}));
  return pairs;
}

} // namespace

ContactNetwork listed_contacts(const Frame& list, const ContactColumns& columns,
                               const ParticleSet& set) {
  const std::vector<Pair> pairs = row_pairs(list, columns, set);
  std::map<Pair, std::vector<double>> overlaps;
  for (std::size_t row = 0; row < list.rows; ++row)
    overlaps[pairs[row]].push_back(
        columns.overlap.empty() ? 0.0 : list.required(columns.overlap, "the overlap")[row]);
  ContactNetwork network;
  for (const auto& [pair, values] : overlaps) {
    network.pairs.push_back({pair.first, pair.second, network.contacts.size(), values.size(),
                             *std::max_element(values.begin(), values.end())});
    for (const double overlap : values)
      network.contacts.push_back({{}, {}, overlap});
  }
  return network;
}

std::vector<ForceLink> force_links(const Frame& list, const ContactColumns& columns,
                                   const ParticleSet& set) {
  const std::vector<Pair> pairs = row_pairs(list, columns, set);
  const std::vector<double> forces = row_forces(list, columns);
  std::map<Pair, double> force_of_pair;
  for (std::size_t row = 0; row < list.rows; ++row)
    force_of_pair[pairs[row]] += forces[row];
  std::vector<ForceLink> links;
  const PeriodicCell cell(set.box);
  for (const auto& [pair, force] : force_of_pair) {
    const Vector3 begin = set.particles[pair.first].centre;
    if (force > 0.0)
      links.push_back({begin, begin + cell.nearest(set.particles[pair.second].centre - begin),
                       force, pair.first, pair.second});
  }
  return links;
}

} // namespace ellipsoid::post
