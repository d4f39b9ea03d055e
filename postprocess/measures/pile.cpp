// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pile.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace ellipsoid::post {
namespace {

/// Sets that are joined one pair at a time; the root of a set is its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : m_parent(count) {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    const std::size_t p = root(i), q = root(j);
    m_parent[std::max(p, q)] = std::min(p, q);
  }

 private:
  std::vector<std::size_t> m_parent;
};

double mean_z(const ParticleSet& set) {
  double sum = 0.0;
  for (const Particle& p : set.particles)
    sum += p.centre.z;
  return sum / static_cast<double>(set.particles.size());
}

} // namespace

std::vector<std::size_t> pile_members(const ParticleSet& set, const PileOptions& options,
                                      double gap) {
  const std::size_t count = set.particles.size();
  DisjointSets clusters(count);
  for (const PairContact& pair : find_contacts(set, gap).pairs)
    clusters.join(pair.i, pair.j);
  std::vector<std::size_t> size(count, 0);
  std::vector<char> touches_wall(count, 0);
  bool any_touches = false;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t root = clusters.root(i);
    ++size[root];
    if (options.wall) {
      const PlaneWall wall{{*options.wall, 0.0, 0.0}, {1.0, 0.0, 0.0}};
      if (!wall_overlaps(set, i, wall, gap).empty())
        touches_wall[root] = any_touches = true;
    }
  }
  std::size_t best = count;
  for (std::size_t i = 0; i < count; ++i)
    if (size[i] > 0 && (!any_touches || touches_wall[i]) && (best == count || size[i] > size[best]))
      best = i;
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < count; ++i)
    if (clusters.root(i) == best)
      members.push_back(i);
  return members;
}

Pile find_pile(const ParticleSet& set, const PileOptions& options) {
  if (set.particles.empty())
    throw InputError("a pile needs at least one particle, the frame has none");
  const double section = options.section.value_or(mean_z(set));
  const double gap = options.cluster_gap * mean_smallest_axis(set, all_members(set));
  std::vector<std::size_t> members = pile_members(set, options, gap);
  const double mean_a = mean_largest_axis(set, members), mean_b = mean_smallest_axis(set, members);
  double out_of_plane = 0.0;
  for (const std::size_t i : members)
    out_of_plane = std::max(out_of_plane, std::abs(set.particles[i].centre.z - section));
  std::vector<PlaneEllipse> shapes = outlines(set, members, section, options.outline);
  if (shapes.empty())
    throw InputError(fmt::format("the plane z = {} cuts no particle of the pile", section));
  UpperEnvelope surface(shapes, options.floor);
  const double left = options.wall ? *options.wall : surface.left(), right = surface.right();
  const std::size_t strays = set.particles.size() - members.size();
  return {std::move(members), strays, section, out_of_plane, std::move(shapes),
          std::move(surface), left,   right,   mean_a,       mean_b};
}

} // namespace ellipsoid::post
