// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pair_distributions.h"

#include "cell_images.h"
#include "contacts.h"
#include "ellipsoid/ellipsoid_contact.h"
#include "orientation.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

std::vector<Vector3> centres_of(const ParticleSet& set) {
  std::vector<Vector3> centres;
  for (const Particle& p : set.particles)
    centres.push_back(p.centre);
  return centres;
}

/// The region's volume as seen by a pair at distance r: the mean over all directions u of the
/// product over the edges of L (those that repeat) or L - r |u_k|.
class RegionSeen {
 public:
  RegionSeen(const std::vector<Vector3>& centres, const PeriodicCell& cell) {
    const bool is_whole = cell.is_periodic(0) && cell.is_periodic(1) && cell.is_periodic(2);
    if (cell.is_tilted() && !is_whole)
      throw InputError("pairs in a tilted box need a box that is periodic along x, y and z");
    if (is_whole) {
      volume_ = cell.volume();
      for (std::size_t k = 0; k < 3; ++k)
        farthest_ = std::min(farthest_, 0.5 * cell.thickness(k));
      return;
    }
    Vector3 low = centres.front(), high = low;
    for (const Vector3& c : centres) {
      low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
      high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
    }
    const double extents[3] = {high.x - low.x, high.y - low.y, high.z - low.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = cell.is_periodic(k) ? cell.thickness(k) : extents[k];
      volume_ *= length;
      farthest_ = std::min(farthest_, cell.is_periodic(k) ? 0.5 * length : length);
      if (!cell.is_periodic(k))
        open_edges_.push_back(length);
    }
  }
  double volume() const { return volume_; }
  double farthest() const { return farthest_; }
  double at(double r) const {
    constexpr double mean_one = 0.5, mean_two = 2.0 / (3.0 * M_PI), mean_three = 1.0 / (4.0 * M_PI);
    double first = 0.0, second = 0.0, third = 0.0; // sums of products of r / L
    if (open_edges_.size() == 3)
      third = r * r * r / (open_edges_[0] * open_edges_[1] * open_edges_[2]);
    for (std::size_t k = 0; k < open_edges_.size(); ++k) {
      first += r / open_edges_[k];
      for (std::size_t l = 0; l < k; ++l)
        second += r * r / (open_edges_[k] * open_edges_[l]);
    }
    return volume_ * (1.0 - mean_one * first + mean_two * second - mean_three * third);
  }

 private:
  double volume_ = 1.0, farthest_ = 1.0e300;
  std::vector<double> open_edges_; ///< lengths of the edges that do not repeat
};

EllipsoidShape ball(double radius) { return make_shape({radius, radius, radius}, {}); }

double gap_of(const EllipsoidShape& i, const EllipsoidShape& j, const Vector3& way) {
  SearchOptions exact;
  exact.goal = SearchGoal::distance;
  return -find_contact(i, j, way, exact).overlap;
}

/// The smallest of the gaps between an ellipsoid and the spheres of a body.
double gap_to_spheres(const ParticleSet& set, const Particle& smooth, const Particle& chain,
                      const Vector3& shift) {
  const EllipsoidShape shape = make_shape(smooth.semiaxes, smooth.orientation);
  double smallest = 1.0e300;
  for (std::size_t k = chain.first_sphere; k < chain.first_sphere + chain.sphere_count; ++k)
    smallest = std::min(smallest, gap_of(shape, ball(set.spheres[k].radius),
                                         set.spheres[k].centre + shift - smooth.centre));
  return smallest;
}

/// The axis that orientation is told by, of each particle; nothing of spheres.
std::vector<std::optional<Vector3>> body_axes(const ParticleSet& set) {
  std::vector<std::optional<Vector3>> axes;
  for (const Particle& p : set.particles) {
    const BodyAxis axis = body_axis(p);
    const auto by_length = axes_by_length(p);
    axes.push_back(axis == BodyAxis::none      ? std::optional<Vector3>()
                   : axis == BodyAxis::longest ? by_length[0]
                                               : by_length[2]);
  }
  return axes;
}

/// Pairs at one distance, those of them that both have an axis, and the sum of their P2.
struct PairsAtDistance {
  double pairs = 0.0, directed = 0.0, order = 0.0;
};

std::vector<PairsAtDistance> pairs_by_distance(const ParticleSet& set,
                                               const std::vector<Vector3>& centres,
                                               const PeriodicCell& cell, double farthest,
                                               std::size_t count) {
  const double width = farthest / static_cast<double>(count);
  const auto axes = body_axes(set);
  std::vector<PairsAtDistance> bins(count);
  BallsWithImages balls(centres, std::vector<double>(centres.size(), 0.5 * farthest), cell);
  balls.for_pairs([&](std::size_t i, std::size_t j, const Vector3& shift) {
    const auto k = static_cast<std::size_t>(norm(centres[j] + shift - centres[i]) / width);
    if (k >= count)
      return;
    bins[k].pairs += 1.0;
    if (!axes[i] || !axes[j])
      return;
    const double cosine = dot(*axes[i], *axes[j]);
    bins[k].directed += 1.0;
    bins[k].order += 1.5 * cosine * cosine - 0.5;
  });
  return bins;
}

} // namespace

double largest_pair_distance(const ParticleSet& set, const PeriodicCell& cell) {
  return RegionSeen(centres_of(set), cell).farthest();
}

std::vector<DistanceBin> pair_distribution(const ParticleSet& set, const PeriodicCell& cell,
                                           double farthest, int bins) {
  if (set.particles.size() < 2)
    throw InputError("pairs need at least two particles");
  const std::vector<Vector3> centres = centres_of(set);
  const RegionSeen region(centres, cell);
  if (!(farthest <= region.farthest()))
    throw InputError(
        fmt::format("distances up to {} m are too long for this box: choose at most {}", farthest,
                    region.farthest()));
  const auto counted =
      pairs_by_distance(set, centres, cell, farthest, static_cast<std::size_t>(bins));
  const double width = farthest / bins;
  const double n = static_cast<double>(centres.size());
  std::vector<DistanceBin> result;
  for (std::size_t k = 0; k < counted.size(); ++k) {
    DistanceBin bin;
    bin.begin = width * static_cast<double>(k);
    bin.end = bin.begin + width;
    const double middle = 0.5 * (bin.begin + bin.end);
    const double shell = 4.0 / 3.0 * M_PI * (std::pow(bin.end, 3) - std::pow(bin.begin, 3));
    const double expected =
        0.5 * n * (n - 1.0) * shell * region.at(middle) / (region.volume() * region.volume());
    bin.g = counted[k].pairs / expected;
    if (counted[k].directed > 0.0)
      bin.g2 = counted[k].order / counted[k].directed;
    result.push_back(bin);
  }
  return result;
}

double surface_gap(const ParticleSet& set, std::size_t i, std::size_t j, const Vector3& shift) {
  const Particle &p = set.particles[i], &q = set.particles[j];
  if (p.is_smooth() && q.is_smooth())
    return gap_of(make_shape(p.semiaxes, p.orientation), make_shape(q.semiaxes, q.orientation),
                  q.centre + shift - p.centre);
  if (p.is_smooth())
    return gap_to_spheres(set, p, q, shift);
  if (q.is_smooth())
    return gap_to_spheres(set, q, p, -shift);
  double smallest = 1.0e300;
  for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k)
    for (std::size_t l = q.first_sphere; l < q.first_sphere + q.sphere_count; ++l) {
      const Sphere &s = set.spheres[k], &t = set.spheres[l];
      smallest = std::min(smallest, norm(t.centre + shift - s.centre) - s.radius - t.radius);
    }
  return smallest;
}

std::vector<GapBin> gap_distribution(const ParticleSet& set, const PeriodicCell& cell,
                                     double lowest, double highest, int bins) {
  std::vector<double> radii;
  for (const Particle& p : set.particles)
    radii.push_back(bounding_radius(set, p) + 0.5 * std::max(0.0, highest));
  const double width = (highest - lowest) / bins;
  std::vector<double> counts(static_cast<std::size_t>(bins), 0.0);
  double below = 0.0;
  BallsWithImages balls(centres_of(set), radii, cell);
  balls.for_pairs([&](std::size_t i, std::size_t j, const Vector3& shift) {
    const double gap = surface_gap(set, i, j, shift);
    if (gap < lowest)
      below += 1.0;
    else if (const auto bin = static_cast<std::size_t>((gap - lowest) / width); bin < counts.size())
      counts[bin] += 1.0;
  });
  const double per_particle = 2.0 / static_cast<double>(std::max<std::size_t>(1, radii.size()));
  std::vector<GapBin> result;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    below += counts[k];
    const double begin = lowest + width * static_cast<double>(k);
    result.push_back(
        {begin, begin + width, per_particle * counts[k] / width, per_particle * below});
  }
  return result;
}

std::vector<StructureBin> structure_factor(const ParticleSet& set, const PeriodicCell& cell,
                                           double highest, int bins) {
  if (set.particles.empty())
    throw InputError("there are no particles");
  if (!(cell.is_periodic(0) && cell.is_periodic(1) && cell.is_periodic(2)))
    throw InputError("a structure factor needs a box that is periodic along x, y and z");
  const double width = highest / bins;
  std::vector<StructureBin> result(static_cast<std::size_t>(bins));
  std::array<int, 3> most;
  std::array<Vector3, 3> reciprocal;
  for (std::size_t k = 0; k < 3; ++k) {
    reciprocal[k] =
        (2.0 * M_PI / cell.volume()) * cross(cell.edge((k + 1) % 3), cell.edge((k + 2) % 3));
    most[k] = static_cast<int>(highest * norm(cell.edge(k)) / (2.0 * M_PI));
  }
  for (int i = -most[0]; i <= most[0]; ++i)
    for (int j = -most[1]; j <= most[1]; ++j)
      for (int k = -most[2]; k <= most[2]; ++k) {
        const Vector3 wave =
            double(i) * reciprocal[0] + double(j) * reciprocal[1] + double(k) * reciprocal[2];
        const auto bin = static_cast<std::size_t>(norm(wave) / width);
        if (bin >= result.size() || (i == 0 && j == 0 && k == 0))
          continue;
        double cosine = 0.0, sine = 0.0;
        for (const Particle& p : set.particles) {
          cosine += std::cos(dot(wave, p.centre));
          sine += std::sin(dot(wave, p.centre));
        }
        ++result[bin].vectors;
        result[bin].wave_number += norm(wave);
        result[bin].s +=
            (cosine * cosine + sine * sine) / static_cast<double>(set.particles.size());
      }
  for (StructureBin& bin : result)
    if (bin.vectors > 0) {
      bin.wave_number /= static_cast<double>(bin.vectors);
      bin.s /= static_cast<double>(bin.vectors);
    }
  return result;
}

} // namespace ellipsoid::post
