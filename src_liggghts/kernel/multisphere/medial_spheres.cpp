// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/medial_spheres.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

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

/// From the touching point to the sphere; its mirror images are farther away, as x, y >= 0.
double gap_to(const Candidate& candidate, const MirroredSphere& sphere) {
  const double dx = candidate.touching.x - sphere.x, dy = candidate.touching.y - sphere.y,
               dz = candidate.touching.z;
  return std::sqrt(dx * dx + dy * dy + dz * dz) - sphere.radius;
}

void update_gaps(std::vector<Candidate>& candidates, const MirroredSphere& sphere) {
  for (Candidate& candidate : candidates)
    candidate.gap = std::min(candidate.gap, gap_to(candidate, sphere));
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

/// A pair on the longest axis takes the centre sphere's place. The gap that it leaves may be so
/// many times the least that any pair leaves: its two spheres can then be farther apart.
constexpr double room_of_pair = 1.25;

/// Touching points to which the centre sphere, the first of those placed, is the nearest, with the
/// gaps that the others leave; in `floor` the largest gap elsewhere.
std::vector<Candidate> left_by_centre(const std::vector<Candidate>& candidates,
                                      const std::vector<MirroredSphere>& placed, double& floor) {
  std::vector<Candidate> open;
  floor = 0.0;
  for (const Candidate& candidate : candidates) {
    Candidate other = candidate;
    other.gap = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < placed.size(); ++k)
      other.gap = std::min(other.gap, gap_to(candidate, placed[k]));
    if (other.gap > candidate.gap)
      open.push_back(other);
    else
      floor = std::max(floor, candidate.gap);
  }
  return open;
}

bool is_placed(const MirroredSphere& sphere, const std::vector<MirroredSphere>& placed) {
  return std::any_of(placed.begin(), placed.end(), [&sphere](const MirroredSphere& other) {
    return other.x == sphere.x && other.y == sphere.y;
  });
}

/// The pair that takes the centre sphere's place: of those that are not placed yet and leave a gap
/// within the room, the one farthest apart.
MirroredSphere pair_for_centre(const std::vector<Candidate>& candidates,
                               const std::vector<MirroredSphere>& placed) {
  double floor = 0.0, least = std::numeric_limits<double>::infinity();
  const std::vector<Candidate> open = left_by_centre(candidates, placed, floor);
  std::vector<std::pair<MirroredSphere, double>> pairs; // with the gaps they leave
  for (const Candidate& pair : candidates) {
    if (!(pair.sphere.x > 0.0) || pair.touching.y > 0.0 || is_placed(pair.sphere, placed))
      continue;
    double gap = floor;
    for (const Candidate& candidate : open)
      gap = std::max(gap, std::min(candidate.gap, gap_to(candidate, pair.sphere)));
    pairs.emplace_back(pair.sphere, gap);
    least = std::min(least, gap);
  }
  MirroredSphere best;
  for (const auto& [pair, gap] : pairs)
    if (gap <= room_of_pair * least && pair.x > best.x)
      best = pair;
  return best;
}

/// All candidates of the plane of the longest and the shortest axis, and one in seven of the
/// others, which are as many as the gap of a pair needs.
std::vector<Candidate> some_with_gaps(const std::vector<Candidate>& candidates,
                                      const MirroredSphere& sphere) {
  std::vector<Candidate> some;
  for (std::size_t k = 0; k < candidates.size(); ++k)
    if (k % 7 == 0 || !(candidates[k].touching.y > 0.0))
      some.push_back(candidates[k]);
  update_gaps(some, sphere);
  return some;
}

/// Whether no gap is larger than the one at the ellipsoid's shortest axis, the first candidate.
bool is_largest_at_centre(const std::vector<Candidate>& candidates) {
  return std::none_of(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
    return candidate.gap > candidates.front().gap * (1.0 + equal_gaps);
  });
}

/// A pair on the longest axis that divides what lies between the two innermost spheres there into
/// three: their touching points come as near to the centre as a third of those spheres'.
MirroredSphere pair_within(const SortedSemiaxes& axes, const std::vector<MirroredSphere>& placed) {
  double innermost = std::numeric_limits<double>::infinity();
  for (const MirroredSphere& sphere : placed)
    if (sphere.x > 0.0 && !(sphere.y > 0.0))
      innermost = std::min(innermost, sphere.x);
  const double reach = (axes.a - axes.c) * (axes.a + axes.c) / axes.a; // centre per touching point
  const double w = innermost / reach / 3.0;
  return inscribed_sphere(axes, {w, 0.0, std::sqrt(1.0 - w * w)});
}

} // namespace

MirroredSphere inscribed_sphere(const SortedSemiaxes& axes, const Vector3& w) {
  const double p = (axes.a - axes.c) * (axes.a + axes.c) / axes.a,
               q = (axes.b - axes.c) * (axes.b + axes.c) / axes.b;
  // the normal's length at the touching point: R = c^2 / distance of the tangent plane
  const double u = axes.c / axes.a * w.x, v = axes.c / axes.b * w.y;
  return {p * w.x, q * w.y, axes.c * std::sqrt(u * u + v * v + w.z * w.z)};
}

std::vector<MirroredSphere> medial_levels(const SortedSemiaxes& axes, int count) {
  std::vector<Candidate> candidates = candidates_on(axes);
  std::vector<MirroredSphere> placed{{0.0, 0.0, axes.c}};
  if (count % 2 == 0)
    placed.front() = pair_for_centre(some_with_gaps(candidates, placed.front()), placed);
  update_gaps(candidates, placed.back());
  for (int left = count - placed.back().count(); left > 0; left -= placed.back().count()) {
    const bool is_at_centre = count % 2 == 0 && is_largest_at_centre(candidates);
    placed.push_back(is_at_centre ? pair_within(axes, placed) : next_of(candidates, 4).sphere);
    update_gaps(candidates, placed.back());
  }
  return placed;
}

std::vector<MirroredSphere> mirrored_medial_spheres(const SortedSemiaxes& axes, int count) {
  std::vector<Candidate> candidates = candidates_on(axes);
  std::vector<MirroredSphere> placed{{0.0, 0.0, axes.c}};
  update_gaps(candidates, placed.back());
  const int odd = count - 1 + count % 2;
  for (int left = odd - 1; left > 0; left -= placed.back().count()) {
    placed.push_back(next_of(candidates, left).sphere);
    update_gaps(candidates, placed.back());
  }
  if (odd < count)
    placed.front() = pair_for_centre(candidates, placed);
  return placed;
}

} // namespace ellipsoid
