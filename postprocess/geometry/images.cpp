// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "images.h"

#include "contacts.h"
#include "periodic_cell.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// Whether a ball reaches into a rectangular part of space.
bool reaches(const Vector3& centre, double radius, const Vector3& lower, const Vector3& upper) {
  return centre.x + radius > lower.x && centre.x - radius < upper.x &&
         centre.y + radius > lower.y && centre.y - radius < upper.y &&
         centre.z + radius > lower.z && centre.z - radius < upper.z;
}

void add_image(ParticleSet& images, const ParticleSet& set, Particle particle,
               const Vector3& shift) {
  const std::size_t first = particle.first_sphere;
  particle.centre += shift;
  particle.first_sphere = images.spheres.size();
  for (std::size_t k = first; k < first + particle.sphere_count; ++k)
    images.spheres.push_back({set.spheres[k].centre + shift, set.spheres[k].radius});
  images.particles.push_back(particle);
}

} // namespace

ParticleSet with_images(const ParticleSet& set, const Vector3& lower, const Vector3& upper) {
  const PeriodicCell cell(set.box);
  if (!cell.is_periodic())
    return set;
  double largest = 0.0;
  for (const Particle& p : set.particles)
    largest = std::max(largest, bounding_radius(set, p));
  // farther than this from the cell's planes no point of the part is
  const double reach = norm(upper - lower) + norm(lower - cell.corner()) + largest;
  double count = 1.0;
  for (std::size_t k = 0; k < 3; ++k)
    count *= cell.is_periodic(k) ? 2.0 * std::ceil(reach / cell.thickness(k)) + 1.0 : 1.0;
  constexpr double most = 1.0e5;
  if (!(count <= most))
    throw InputError(
        fmt::format("the region needs {:.3g} images of the box (at most {:.0e}): choose "
                    "a region in or near the box",
                    count, most));
  ParticleSet images = set;
  images.particles.clear();
  images.spheres.clear();
  images.sphere_ids.clear(); // lists of contacts name no images
  const std::vector<Vector3> shifts = cell.shifts(reach);
  for (const Particle& p : set.particles) {
    const double radius = bounding_radius(set, p);
    const Vector3 into_cell = cell.wrapped(p.centre) - p.centre;
    for (const Vector3& shift : shifts)
      if (reaches(p.centre + into_cell + shift, radius, lower, upper))
        add_image(images, set, p, into_cell + shift);
  }
  return images;
}

void refuse_repeating(const Box& box, std::size_t first, std::size_t second, const char* what) {
  const PeriodicCell cell(box);
  for (const std::size_t axis : {first, second})
    if (cell.is_periodic(axis))
      throw InputError(
          fmt::format("the box repeats along {}, {} ends there: --periodic none takes no "
                      "images",
                      "xyz"[axis], what));
}

} // namespace ellipsoid::post
