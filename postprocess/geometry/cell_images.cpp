// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "cell_images.h"

#include <algorithm>

namespace ellipsoid::post {
namespace {

/// Whether a ball about `point` comes into the cell.
bool reaches(const PeriodicCell& cell, const Vector3& point, double radius) {
  const Vector3 f = cell.fractions(point);
  const double shares[3] = {f.x, f.y, f.z};
  for (std::size_t k = 0; k < 3; ++k)
    if (cell.is_periodic(k) &&
        (shares[k] * cell.thickness(k) < -radius || (shares[k] - 1.0) * cell.thickness(k) > radius))
      return false;
  return true;
}

bool is_forward(const Vector3& d) {
  return d.z > 0.0 || (d.z == 0.0 && (d.y > 0.0 || (d.y == 0.0 && d.x > 0.0)));
}

} // namespace

std::vector<CellImage> cell_images(const std::vector<Vector3>& centres,
                                   const std::vector<double>& radii, const PeriodicCell& cell) {
  std::vector<CellImage> images;
  double largest = 0.0;
  for (const double radius : radii)
    largest = std::max(largest, radius);
  for (std::size_t i = 0; i < centres.size(); ++i)
    images.push_back({i, cell.wrapped(centres[i]) - centres[i]});
  const std::vector<Vector3> shifts = cell.shifts(2.0 * largest);
  for (std::size_t i = 0; i < centres.size(); ++i)
    for (std::size_t k = 1; k < shifts.size(); ++k) {
      const Vector3 shift = images[i].shift + shifts[k];
      if (reaches(cell, centres[i] + shift, radii[i] + largest))
        images.push_back({i, shift});
    }
  return images;
}

bool counts_as_pair(const std::vector<CellImage>& images, std::size_t p, std::size_t q,
                    std::size_t count) {
  if (p >= count) // images of both
    return false;
  if (q < count)
    return true;
  const std::size_t i = images[p].owner, j = images[q].owner;
  return i < j || (i == j && is_forward(images[q].shift - images[p].shift));
}

} // namespace ellipsoid::post
