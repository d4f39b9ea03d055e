// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pile.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

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
  const std::vector<std::size_t> clusters = touching_clusters(set, gap);
  std::vector<std::size_t> size(count, 0);
  std::vector<char> touches_wall(count, 0);
  bool any_touches = false;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t root = clusters[i];
    ++size[root];
    if (options.wall && !touches_wall[root]) {
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
    if (clusters[i] == best)
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
