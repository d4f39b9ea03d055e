// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/medial_spheres.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ellipsoid {
namespace {

constexpr double pi = 3.141592653589793238462643;

/// Circles of latitude of the grid of touching points over an eighth of the ellipsoid. The grid is
/// the same for every N, so that levels hold each other; its meshes are smaller than the
/// distances of the 9999 spheres that are allowed.
constexpr int latitudes = 240;

/// Of gaps that are equal to rounding, as symmetry makes them, the first one counts.
constexpr double equal_gaps = 1e-9;

struct Candidate {
  Vector3 touching; ///< on the ellipsoid (length)
  MirroredSphere sphere;
  double gap = 0.0; ///< from the touching point to the spheres placed so far (length)
};

std::vector<Candidate> candidates_on(const SortedSemiaxes& axes) {
  std::vector<Candidate> candidates;
  for (int i = 0; i <= latitudes; ++i) {
    const double sine = i == latitudes ? 1.0 : std::sin(0.5 * pi * i / latitudes);
    const double cosine = i == latitudes ? 0.0 : std::cos(0.5 * pi * i / latitudes);
    const int parts = static_cast<int>(std::ceil(sine * latitudes));
    for (int j = 0; j <= parts; ++j) {
      const double angle = parts > 0 ? 0.5 * pi * j / parts : 0.0;
      const Vector3 w{j == parts && parts > 0 ? 0.0 : sine * std::cos(angle),
                      j == 0 ? 0.0 : sine * std::sin(angle), cosine};
      candidates.push_back(
          {{axes.a * w.x, axes.b * w.y, axes.c * w.z}, inscribed_sphere(axes, w), 2.0 * axes.a});
    }
  }
  return candidates;
}

/// Mirror images are farther away from points with x, y >= 0.
void place(std::vector<Candidate>& candidates, const MirroredSphere& sphere) {
  for (Candidate& candidate : candidates) {
    const double dx = candidate.touching.x - sphere.x, dy = candidate.touching.y - sphere.y,
                 dz = candidate.touching.z;
    candidate.gap = std::min(candidate.gap, std::sqrt(dx * dx + dy * dy + dz * dz) - sphere.radius);
  }
}

/// Where the gap is largest among candidates of at most so many spheres.
const Candidate& next_of(const std::vector<Candidate>& candidates, int largest_count) {
  const Candidate* best = nullptr;
  for (const Candidate& candidate : candidates)
    if (candidate.sphere.count() > 1 && candidate.sphere.count() <= largest_count &&
        (!best || candidate.gap > best->gap * (1.0 + equal_gaps)))
      best = &candidate;
  return *best;
}

} // namespace

MirroredSphere inscribed_sphere(const SortedSemiaxes& axes, const Vector3& w) {
  const double p = (axes.a - axes.c) * (axes.a + axes.c) / axes.a,
               q = (axes.b - axes.c) * (axes.b + axes.c) / axes.b;
  // the normal's length at the touching point: R = c^2 / distance of the tangent plane
  const double u = axes.c / axes.a * w.x, v = axes.c / axes.b * w.y;
  return {p * w.x, q * w.y, axes.c * std::sqrt(u * u + v * v + w.z * w.z)};
}

std::vector<MirroredSphere> medial_spheres(const SortedSemiaxes& axes, int count) {
  std::vector<Candidate> candidates = candidates_on(axes);
  std::vector<MirroredSphere> placed{{0.0, 0.0, axes.c}};
  place(candidates, placed.back());
  for (int left = count - 1; left > 0; left -= placed.back().count()) {
    placed.push_back(next_of(candidates, left).sphere);
    place(candidates, placed.back());
  }
  return placed;
}

} // namespace ellipsoid
