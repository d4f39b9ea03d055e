// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Spacing `minimax_volume`. Along the ray through the ellipsoid's point s the spheres end at t s;
// in coordinates in which the ellipsoid is the unit ball the volume in exactly one of the two, as a
// share of the ellipsoid's, is the mean of |t^3 - 1| over directions. That mean over fixed
// directions is made smallest.
#include "multisphere/medial_spheres.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <utility>

namespace ellipsoid {
namespace {

constexpr double pi = 3.141592653589793238462643;

constexpr int directions_of_any = 3000, directions_per_sphere = 40; ///< in an eighth
constexpr int relaxations = 12;  ///< after them places move less than the descent moves them
constexpr int descents = 120;    ///< steps; the mean falls by less than 1e-3 of itself after these
constexpr int near_count = 12;   ///< spheres that may end a ray until they are searched again
constexpr int refresh_steps = 8; ///< steps between two searches
constexpr int start_candidates = 700; ///< in the plane, and on each of its axes

/// A direction of the mean, with the spheres that are near it.
struct Ray {
  Vector3 end;           ///< on the ellipsoid (length)
  double square = 0.0;   ///< its squared length
  std::vector<int> near; ///< indices
};

/// Even over an eighth of the unit sphere: a lattice of the golden ratio.
std::vector<Ray> rays_over(const SortedSemiaxes& axes, int count) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const double z = (i + 0.5) / count, r = std::sqrt(1.0 - z * z),
                 turn = 0.6180339887498949 * (i + 0.5),
                 angle = 0.5 * pi * (turn - std::floor(turn));
    const Vector3 end{axes.a * r * std::cos(angle), axes.b * r * std::sin(angle), axes.c * z};
    rays.push_back({end, dot(end, end), {}});
  }
  return rays;
}

/// Where the ray leaves the sphere, in units of its end; 0 if it misses it. Mirror images are left
/// earlier or not met.
double exit_of(const Ray& ray, const MirroredSphere& s) {
  const double along = ray.end.x * s.x + ray.end.y * s.y;
  const double inside = s.radius * s.radius - s.x * s.x - s.y * s.y;
  const double square = along * along + ray.square * inside;
  return square > 0.0 ? std::max(0.0, (along + std::sqrt(square)) / ray.square) : 0.0;
}

void find_near(std::vector<Ray>& rays, const std::vector<MirroredSphere>& spheres) {
  std::vector<std::pair<double, int>> exits(spheres.size());
  const std::size_t kept = std::min<std::size_t>(near_count, spheres.size());
  for (Ray& ray : rays) {
    for (std::size_t k = 0; k < spheres.size(); ++k)
      exits[k] = {-exit_of(ray, spheres[k]), static_cast<int>(k)};
    std::partial_sort(exits.begin(), exits.begin() + static_cast<std::ptrdiff_t>(kept),
                      exits.end());
    ray.near.clear();
    for (std::size_t k = 0; k < kept; ++k)
      ray.near.push_back(exits[k].second);
  }
}

struct Exit {
  double share = 0.0; ///< of the ray's end
  int sphere = 0;
};

Exit farthest_exit(const Ray& ray, const std::vector<MirroredSphere>& spheres) {
  Exit farthest{0.0, ray.near.front()};
  for (const int k : ray.near) {
    const double share = exit_of(ray, spheres[static_cast<std::size_t>(k)]);
    if (share > farthest.share)
      farthest = {share, k};
  }
  return farthest;
}

/// Each centre moves to the mean of the medial points of the rays that it ends: Lloyd's iteration,
/// which keeps symmetry: a sphere on an axis stays there.
void relax(const SortedSemiaxes& axes, const std::vector<Ray>& rays,
           std::vector<MirroredSphere>& spheres) {
  std::vector<Vector3> sums(spheres.size());
  std::vector<int> counts(spheres.size(), 0);
  for (const Ray& ray : rays) {
    const auto k = static_cast<std::size_t>(farthest_exit(ray, spheres).sphere);
    sums[k] += {ray.end.x / axes.a, ray.end.y / axes.b, 0.0};
    ++counts[k];
  }
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (counts[k] == 0)
      continue;
    Vector3 w = (1.0 / counts[k]) * sums[k];
    w.x = spheres[k].x > 0.0 ? w.x : 0.0;
    w.y = spheres[k].y > 0.0 ? w.y : 0.0;
    w.z = std::sqrt(std::max(0.0, 1.0 - w.x * w.x - w.y * w.y));
    const MirroredSphere moved = inscribed_sphere(axes, w);
    if (moved.count() == spheres[k].count())
      spheres[k] = moved;
  }
}

/// Mean of |t^3 - 1| and its derivatives by each x, y and radius.
double mean_difference(const std::vector<Ray>& rays, const std::vector<MirroredSphere>& spheres,
                       std::vector<MirroredSphere>& slopes) {
  double sum = 0.0;
  slopes.assign(spheres.size(), {});
  for (const Ray& ray : rays) {
    const auto [t, k] = farthest_exit(ray, spheres);
    sum += std::fabs(t * t * t - 1.0);
    if (t == 0.0)
      continue;
    const MirroredSphere& s = spheres[static_cast<std::size_t>(k)];
    const Vector3 normal = t * ray.end - Vector3{s.x, s.y, 0.0}; // times the radius
    const double change = (t > 1.0 ? 3.0 : -3.0) * t * t / dot(normal, ray.end);
    MirroredSphere& slope = slopes[static_cast<std::size_t>(k)];
    slope.x += change * normal.x;
    slope.y += change * normal.y;
    slope.radius += change * s.radius;
  }
  return sum / static_cast<double>(rays.size());
}

/// One unknown of the descent: it goes against its slope by a step of its own, which grows while
/// the slope keeps its sign and is halved where it turns (Riedmiller, Braun 1993, "Rprop").
struct Unknown {
  double step = 0.0, last_slope = 0.0;

  double move(double slope, double largest) {
    if (slope * last_slope > 0.0)
      step = std::min(1.2 * step, largest);
    else if (slope * last_slope < 0.0)
      step *= 0.5;
    last_slope = slope;
    return slope > 0.0 ? -step : slope < 0.0 ? step : 0.0;
  }
};

struct Lowest {
  std::vector<MirroredSphere> spheres;
  double mean = 1e300;
};

class Descent {
 public:
  Descent(const SortedSemiaxes& axes, std::vector<MirroredSphere> start)
      : largest_(0.05 * axes.c), spheres_(std::move(start)),
        unknowns_(3 * spheres_.size(), Unknown{0.01 * axes.c, 0.0}) {}

  Lowest lowest(std::vector<Ray>& rays) {
    Lowest best;
    std::vector<MirroredSphere> slopes;
    for (int i = 0; i < descents; ++i) {
      if (i % refresh_steps == 0)
        find_near(rays, spheres_);
      const double mean = mean_difference(rays, spheres_, slopes);
      if (mean < best.mean)
        best = {spheres_, mean};
      for (std::size_t k = 0; k < spheres_.size(); ++k)
        step(k, slopes[k]);
    }
    return best;
  }

 private:
  void step(std::size_t k, const MirroredSphere& slope) {
    MirroredSphere& s = spheres_[k];
    const double smallest = 1e-6 * largest_; // neither off its side of an axis nor without size
    if (s.x > 0.0)
      s.x = std::max(smallest, s.x + unknowns_[3 * k].move(slope.x, largest_));
    if (s.y > 0.0)
      s.y = std::max(smallest, s.y + unknowns_[3 * k + 1].move(slope.y, largest_));
    s.radius = std::max(smallest, s.radius + unknowns_[3 * k + 2].move(slope.radius, largest_));
  }

  double largest_;
  std::vector<MirroredSphere> spheres_;
  std::vector<Unknown> unknowns_; ///< x, y, radius of each sphere
};

/// How far spheres reach along rays from the centre.
class Coverage {
 public:
  explicit Coverage(const std::vector<Ray>& rays) : rays_(rays), reached_(rays.size(), 0.0) {}
  /// What a sphere adds to the volume, for each sphere that it costs.
  double gain(const MirroredSphere& sphere) const {
    double gain = 0.0;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const double t = exit_of(rays_[i], sphere);
      if (t > reached_[i])
        gain += t * t * t - reached_[i] * reached_[i] * reached_[i];
    }
    return gain / sphere.count();
  }
  void add(const MirroredSphere& sphere) {
    for (std::size_t i = 0; i < rays_.size(); ++i)
      reached_[i] = std::max(reached_[i], exit_of(rays_[i], sphere));
  }

 private:
  const std::vector<Ray>& rays_;
  std::vector<double> reached_;
};

std::vector<MirroredSphere> inscribed_candidates(const SortedSemiaxes& axes) {
  std::vector<MirroredSphere> candidates;
  for (const Ray& ray : rays_over(axes, start_candidates)) {
    const double u = ray.end.x / axes.a, v = ray.end.y / axes.b;
    const double rim = std::sqrt(u * u + v * v);
    candidates.push_back(inscribed_sphere(axes, {u, v, ray.end.z / axes.c}));
    candidates.push_back(inscribed_sphere(axes, {rim, 0.0, ray.end.z / axes.c}));
    candidates.push_back(inscribed_sphere(axes, {0.0, rim, ray.end.z / axes.c}));
  }
  return candidates;
}

/// Inscribed spheres of which each adds the most volume to those before it. What a sphere adds only
/// falls while others are placed, so that it is counted again only when it leads.
std::vector<MirroredSphere> largest_gains(const SortedSemiaxes& axes, int count,
                                          const std::vector<Ray>& rays) {
  const std::vector<MirroredSphere> candidates = inscribed_candidates(axes);
  Coverage covered(rays);
  std::vector<MirroredSphere> placed;
  if (count % 2 == 1) {
    placed.push_back({0.0, 0.0, axes.c});
    covered.add(placed.front());
  }
  std::priority_queue<std::pair<double, std::size_t>> leaders;
  for (std::size_t k = 0; k < candidates.size(); ++k)
    leaders.push({covered.gain(candidates[k]), k});
  for (int left = count - count % 2; left > 0 && !leaders.empty();) {
    const std::size_t k = leaders.top().second;
    leaders.pop();
    if (candidates[k].count() > left || candidates[k].count() == 1)
      continue;
    const double gain = covered.gain(candidates[k]);
    if (!leaders.empty() && gain < leaders.top().first) {
      leaders.push({gain, k});
      continue;
    }
    placed.push_back(candidates[k]);
    left -= placed.back().count();
    covered.add(placed.back());
  }
  return placed;
}

} // namespace

std::vector<MirroredSphere> minimax_volume_spheres(const SortedSemiaxes& axes, int count) {
  std::vector<Ray> rays = rays_over(axes, directions_of_any + directions_per_sphere * count / 4);
  std::vector<MirroredSphere> relaxed = mirrored_medial_spheres(axes, count);
  for (int i = 0; i < relaxations; ++i) {
    if (i % 4 == 0)
      find_near(rays, relaxed);
    relax(axes, rays, relaxed);
  }
  const Lowest first = Descent(axes, std::move(relaxed)).lowest(rays);
  const Lowest second = Descent(axes, largest_gains(axes, count, rays)).lowest(rays);
  return first.mean <= second.mean ? first.spheres : second.spheres;
}

} // namespace ellipsoid
