// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pile.h"

#include "images.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

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
                                      const NearPairs& near,
                                      const std::vector<PairContact>& touching) {
  const std::size_t count = set.particles.size();
  const std::vector<std::size_t> clusters = touching_clusters(set, near, touching);
  std::vector<std::size_t> size(count, 0);
  std::vector<char> touches_wall(count, 0);
  bool any_touches = false;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t root = clusters[i];
    ++size[root];
    if (options.wall && !touches_wall[root]) {
      const PlaneWall wall{{*options.wall, 0.0, 0.0}, {1.0, 0.0, 0.0}};
      if (!wall_overlaps(set, i, wall, near.gap()).empty()) {
        touches_wall[root] = 1;
        any_touches = true;
      }
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

namespace {

/// Extent of the outlines that reach above the floor.
void find_extent(PileBody& pile, const PileOptions& options) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double left = infinity, right = -infinity;
  pile.top = -infinity;
  for (const PlaneEllipse& shape : pile.outlines) {
    const double top = shape.top();
    if (top < options.floor)
      continue;
    pile.top = std::max(pile.top, top);
    left = std::min(left, shape.left());
    right = std::max(right, shape.right());
  }
  const bool is_above = pile.top >= options.floor;
  pile.right = is_above ? right : 0.0;
  pile.left = options.wall ? *options.wall : is_above ? left : 0.0;
}

} // namespace

std::vector<PlaneWall> walls_of(const PileOptions& options) {
  std::vector<PlaneWall> walls = {{{0.0, options.floor, 0.0}, {0.0, 1.0, 0.0}}};
  if (options.wall)
    walls.push_back({{*options.wall, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  return walls;
}

NearPairs near_pairs(const ParticleSet& set, const PileOptions& options) {
  return {set, options.cluster_gap * mean_smallest_axis(set, all_members(set))};
}

PileBody find_pile_body(const ParticleSet& set, const PileOptions& options, NearPairs near,
                        const std::vector<PairContact>& touching) {
  if (set.particles.empty())
    throw InputError("a pile needs at least one particle, the frame has none");
  refuse_repeating(set.box, 0, 1, "a pile in the plane");
  const double section = options.section.value_or(mean_z(set));
  PileBody pile;
  pile.near = std::move(near);
  pile.section = section;
  pile.members = pile_members(set, options, pile.near, touching);
  pile.strays = set.particles.size() - pile.members.size();
  pile.mean_a = mean_largest_axis(set, pile.members);
  pile.mean_b = mean_smallest_axis(set, pile.members);
  for (const std::size_t i : pile.members)
    pile.out_of_plane = std::max(pile.out_of_plane, std::abs(set.particles[i].centre.z - section));
  pile.outlines = outlines(set, pile.members, section, options.outline);
  if (pile.outlines.empty())
    throw InputError(fmt::format("the plane z = {} cuts no particle of the pile", section));
  find_extent(pile, options);
  return pile;
}

Pile find_pile(const ParticleSet& set, const PileOptions& options, NearPairs near,
               const std::vector<PairContact>& touching) {
  PileBody body = find_pile_body(set, options, std::move(near), touching);
  UpperEnvelope surface(body.outlines, options.floor);
  return {std::move(body), std::move(surface)};
}

} // namespace ellipsoid::post
