// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "coordination.h"

#include <algorithm>

namespace ellipsoid::post {
namespace {

/// Pairs with both particles in `is_member`.
std::vector<PairContact> pairs_among(const std::vector<PairContact>& pairs,
                                     const std::vector<char>& is_member) {
  std::vector<PairContact> kept;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(kept),
               [&](const PairContact& p) { return is_member[p.i] && is_member[p.j]; });
  return kept;
}

void add_overlaps(Coordination& result, const ContactNetwork& network,
                  const std::vector<PairContact>& pairs) {
  double sum = 0.0;
  for (const PairContact& pair : pairs) {
    result.contacts += pair.count;
    for (std::size_t k = pair.first; k < pair.first + pair.count; ++k) {
      sum += network.contacts[k].overlap;
      result.largest_overlap = std::max(result.largest_overlap, network.contacts[k].overlap);
    }
  }
  if (result.contacts > 0)
    result.mean_overlap = sum / static_cast<double>(result.contacts);
}

} // namespace

Partners count_partners(const ParticleSet& set, const std::vector<PairContact>& pairs,
                        const CoordinationOptions& options) {
  const std::size_t count = set.particles.size();
  Partners partners{std::vector<std::size_t>(count, 0), std::vector<std::size_t>(count, 0),
                    std::vector<std::size_t>(count, 0)};
  for (const PairContact& pair : pairs) {
    ++partners.particles[pair.i];
    ++partners.particles[pair.j];
  }
  for (std::size_t i = 0; i < count; ++i)
    for (const SpaceWall& wall : options.walls) {
      const std::size_t bodies = bodies_at_wall(set, i, wall, options.gap);
      partners.walls[i] += bodies > 0 ? 1 : 0;
      partners.wall_bodies[i] += bodies;
    }
  return partners;
}

Coordination coordination(const ParticleSet& set, const std::vector<std::size_t>& members,
                          const ContactNetwork& network, const CoordinationOptions& options) {
  std::vector<char> is_member(set.particles.size(), 0), is_backbone(set.particles.size(), 0);
  for (const std::size_t i : members)
    is_member[i] = 1;
  const std::vector<PairContact> pairs = pairs_among(network.pairs, is_member);
  const Partners partners = count_partners(set, pairs, options);
  Coordination result;
  result.particles = members.size();
  result.pairs = pairs.size();
  result.not_converged = network.not_converged;
  add_overlaps(result, network, pairs);
  std::size_t wall_bodies = 0, backbone = 0;
  for (const std::size_t i : members) {
    const std::size_t z = partners.particles[i] + (options.count_walls ? partners.walls[i] : 0);
    if (result.distribution.size() <= z)
      result.distribution.resize(z + 1, 0);
    ++result.distribution[z];
    result.wall_contacts += partners.walls[i];
    wall_bodies += partners.wall_bodies[i];
    is_backbone[i] =
        static_cast<char>(partners.particles[i] + partners.walls[i] >= options.rattler_contacts);
    is_backbone[i] ? ++backbone : ++result.rattlers;
  }
  const auto per = [](std::size_t twice, std::size_t count) {
    return count > 0 ? static_cast<double>(twice) / static_cast<double>(count) : 0.0;
  };
  const std::size_t walls = options.count_walls ? result.wall_contacts : 0;
  result.zpp = per(2 * result.pairs + walls, members.size());
  result.zss = per(2 * result.contacts + (options.count_walls ? wall_bodies : 0), members.size());
  result.zpp_without_rattlers = per(2 * pairs_among(pairs, is_backbone).size(), backbone);
  return result;
}

} // namespace ellipsoid::post
