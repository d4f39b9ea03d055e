// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "heap.h"

#include "images.h"
#include "repose.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// Mean heights over the floor in rings of one sector.
struct Profile {
  std::vector<double> sums;
  std::vector<std::size_t> counts;

  void add(std::size_t ring, double height) {
    if (ring >= sums.size()) {
      sums.resize(ring + 1, 0.0);
      counts.resize(ring + 1, 0);
    }
    sums[ring] += height;
    ++counts[ring];
  }
  double mean(std::size_t ring) const {
    return counts[ring] > 0 ? sums[ring] / static_cast<double>(counts[ring]) : 0.0;
  }
  std::size_t outermost(double height) const {
    std::size_t end = sums.size();
    while (end > 0 && mean(end - 1) < height)
      --end;
    return end;
  }
};

Point axis_of(const HeightMap& map) {
  double volume = 0.0;
  Point sum(0.0, 0.0);
  for (std::size_t j = 0; j < map.columns_y(); ++j)
    for (std::size_t i = 0; i < map.columns_x(); ++i) {
      const double height = map.height(i, j) - map.floor();
      volume += height;
      sum += height * Point(map.x(i), map.y(j));
    }
  if (!(volume > 0.0))
    throw InputError("the heap has no volume above the floor: check --floor and --up");
  return sum / volume;
}

std::vector<Profile> sector_profiles(const HeightMap& map, const Point& axis, int sectors,
                                     double ring_width) {
  std::vector<Profile> profiles(static_cast<std::size_t>(sectors));
  for (std::size_t j = 0; j < map.columns_y(); ++j)
    for (std::size_t i = 0; i < map.columns_x(); ++i) {
      const double dx = map.x(i) - axis.x(), dy = map.y(j) - axis.y();
      const double turn = (std::atan2(dy, dx) + M_PI) / (2.0 * M_PI);
      const int sector = std::min(sectors - 1, static_cast<int>(turn * sectors));
      const auto ring = static_cast<std::size_t>(std::hypot(dx, dy) / ring_width);
      profiles[static_cast<std::size_t>(sector)].add(ring, map.height(i, j) - map.floor());
    }
  return profiles;
}

struct SectorLine {
  double angle_deg;
  double share; ///< of the radius out to B
};

SectorLine sector_line(const Profile& profile, double height, double ring_width,
                       const HeapOptions& options) {
  const std::size_t a = profile.outermost((1.0 - options.cut_top) * height);
  const std::size_t b = profile.outermost(options.cut_bottom * height);
  const std::size_t first = a > 0 ? a - 1 : 0;
  if (b < first + 3)
    throw InputError(fmt::format("a sector of the heap has {} rings between A and B, at least 3 "
                                 "are needed: the heap is too small, or take fewer --sectors",
                                 b > first ? b - first : 0));
  std::vector<Point> points;
  for (std::size_t ring = first; ring < b; ++ring)
    points.emplace_back((static_cast<double>(ring) + 0.5) * ring_width, profile.mean(ring));
  return {std::atan(-fit_line(points).slope) * 180.0 / M_PI,
          static_cast<double>(b - first) / static_cast<double>(b)};
}

/// Particles whose centres lie in one plane along an axis are no heap in space.
void require_space(const ParticleSet& set) {
  for (double Vector3::*axis : {&Vector3::x, &Vector3::y, &Vector3::z}) {
    const double first = set.particles.front().centre.*axis;
    const bool is_flat = std::all_of(set.particles.begin(), set.particles.end(),
                                     [&](const Particle& p) { return p.centre.*axis == first; });
    if (is_flat && set.particles.size() > 2)
      throw InputError("all particles lie in one plane: this is no heap in space; piles in the "
                       "plane are measured by `repose` and `porosity`");
  }
}

} // namespace

HeapAngle heap_angle(const ParticleSet& upright, const HeapOptions& options) {
  if (upright.particles.empty())
    throw InputError("a heap needs at least one particle, the frame has none");
  refuse_repeating(upright.box, 0, 1, "a heap");
  require_space(upright);
  const std::vector<std::size_t> members = largest_cluster(upright, options.cluster_gap);
  const double mean_a = mean_largest_axis(upright, members);
  const double mean_b = mean_smallest_axis(upright, members);
  const HeightMap map(upright, members, options.column_width * mean_b, options.floor);
  const Point axis = axis_of(map);
  const auto profiles = sector_profiles(map, axis, options.sectors, mean_a);
  HeapAngle result;
  result.axis_x = axis.x();
  result.axis_y = axis.y();
  result.members = members.size();
  result.strays = upright.particles.size() - members.size();
  result.volume = map.volume();
  Profile whole;
  for (const Profile& profile : profiles)
    for (std::size_t ring = 0; ring < profile.sums.size(); ++ring)
      if (profile.counts[ring] > 0)
        whole.add(ring, profile.mean(ring));
  for (std::size_t ring = 0; ring < whole.sums.size(); ++ring)
    result.height = std::max(result.height, whole.mean(ring));
  for (const Profile& profile : profiles) {
    const SectorLine line = sector_line(profile, result.height, mean_a, options);
    result.sector_angles_deg.push_back(line.angle_deg);
    result.line_share += line.share / static_cast<double>(options.sectors);
  }
  result.spread = spread_of(result.sector_angles_deg);
  result.standard_error =
      result.spread.standard_deviation / std::sqrt(static_cast<double>(options.sectors));
  return result;
}

std::vector<std::size_t> largest_cluster(const ParticleSet& set, double gap_in_b) {
  PileOptions options;
  options.wall.reset();
  const double gap = gap_in_b * mean_smallest_axis(set, all_members(set));
  return pile_members(set, options, NearPairs(set, gap));
}

} // namespace ellipsoid::post
