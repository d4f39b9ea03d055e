// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Pairs of particles that come near each other, with their images in boxes that repeat.
#include "cell_grid.h"
#include "contacts.h"
#include "periodic_cell.h"

#include <algorithm>
#include <numeric>

namespace ellipsoid::post {

double bounding_radius(const ParticleSet& set, const Particle& p) {
  if (p.is_smooth())
    return p.largest_axis();
  double radius = 0.0;
  for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k)
    radius = std::max(radius, norm(set.spheres[k].centre - p.centre) + set.spheres[k].radius);
  return radius;
}

namespace {

/// Pairs in the order of one of their particles, and else as they were: counted, not compared.
/// @param[in] count of the particles
template <class AnyPair>
std::vector<AnyPair> ordered(const std::vector<AnyPair>& pairs, std::size_t AnyPair::*member,
                             std::size_t count) {
  std::vector<std::size_t> next(count + 1, 0); // index of the next pair of each particle
  for (const AnyPair& pair : pairs)
    ++next[pair.*member + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<AnyPair> result(pairs.size());
  for (const AnyPair& pair : pairs)
    result[next[pair.*member]++] = pair;
  return result;
}

/// A pair and the image of its second particle.
struct ImagePair {
  std::size_t first, second;
  Vector3 shift;
};

/// The balls in a cell and around it: the particles' own, then their images.
struct CellBalls {
  std::vector<Vector3> centres; ///< of particles: in the cell
  std::vector<double> radii;
  std::vector<std::size_t> owners;
  std::vector<Vector3> shifts; ///< from the owner's centre in the file
};

/// All balls whose images reach into the cell or near a ball in it.
CellBalls balls_around(const PeriodicCell& cell, const std::vector<Vector3>& centres,
                       const std::vector<double>& radii) {
  CellBalls balls;
  double largest = 0.0;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    balls.centres.push_back(cell.wrapped(centres[i]));
    balls.owners.push_back(i);
    balls.shifts.push_back(balls.centres[i] - centres[i]);
    largest = std::max(largest, radii[i]);
  }
  balls.radii = radii;
  const std::vector<Vector3> shifts = cell.shifts(2.0 * largest);
  for (std::size_t s = 1; s < shifts.size(); ++s) // the first one is zero
    for (std::size_t i = 0; i < centres.size(); ++i) {
      const Vector3 image = balls.centres[i] + shifts[s];
      if (cell.distance_beyond(image) > largest + radii[i])
        continue;
      balls.centres.push_back(image);
      balls.radii.push_back(radii[i]);
      balls.owners.push_back(i);
      balls.shifts.push_back(balls.shifts[i] + shifts[s]);
    }
  return balls;
}

} // namespace

NearPairs::NearPairs(const ParticleSet& set, double gap) : gap_(gap) {
  std::vector<double> radii;
  radii.reserve(set.particles.size());
  for (const Particle& p : set.particles)
    radii.push_back(bounding_radius(set, p) + 0.5 * gap);
  if (PeriodicCell(set.box).is_periodic()) {
    find_in_cell(set, radii);
    return;
  }
  std::vector<Vector3> centres;
  centres.reserve(set.particles.size());
  for (const Particle& p : set.particles)
    centres.push_back(p.centre);
  CellGrid grid(centres, radii);
  std::vector<Pair> found;
  found.reserve(8 * set.particles.size());
  grid.for_pairs([&](std::size_t i, std::size_t j) { found.emplace_back(i, j); });
  const std::size_t count = set.particles.size();
  pairs_ = ordered(ordered(found, &Pair::second, count), &Pair::first, count);
}

void NearPairs::find_in_cell(const ParticleSet& set, const std::vector<double>& radii) {
  const PeriodicCell cell(set.box);
  std::vector<Vector3> own;
  for (const Particle& p : set.particles)
    own.push_back(p.centre);
  const CellBalls balls = balls_around(cell, own, radii);
  const std::size_t count = set.particles.size();
  std::vector<ImagePair> found;
  CellGrid grid(balls.centres, balls.radii);
  grid.for_pairs([&](std::size_t i, std::size_t j) { // i < j: i is in the cell, or both are images
    const std::size_t owner = balls.owners[j];
    const Vector3 shift = balls.shifts[j] - (i < count ? balls.shifts[i] : Vector3{});
    if (i < count && i < owner)
      found.push_back({i, owner, shift});
    reaches_itself_ = reaches_itself_ || (i < count && i == owner);
  });
  for (const ImagePair& pair :
       ordered(ordered(found, &ImagePair::second, count), &ImagePair::first, count)) {
    pairs_.emplace_back(pair.first, pair.second);
    shifts_.push_back(pair.shift);
  }
}

} // namespace ellipsoid::post
