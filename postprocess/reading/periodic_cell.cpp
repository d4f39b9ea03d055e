// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "periodic_cell.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

bool repeats_along(const Box& box, std::size_t k) {
  const std::string& words = box.boundary; // "pp pp ff"
  return words.size() >= 3 * k + 2 && words[3 * k] == 'p' && words[3 * k + 1] == 'p';
}

} // namespace

PeriodicCell::PeriodicCell(const Vector3& corner, const std::array<Vector3, 3>& edges,
                           const std::array<bool, 3>& is_periodic)
    : corner_(corner), edges_(edges), is_periodic_(is_periodic) {
  prepare();
}

PeriodicCell::PeriodicCell(const Box& box)
    : corner_{box.lower[0], box.lower[1], box.lower[2]},
      edges_{Vector3{box.upper[0] - box.lower[0], 0.0, 0.0},
             Vector3{0.0, box.upper[1] - box.lower[1], 0.0},
             Vector3{0.0, 0.0, box.upper[2] - box.lower[2]}},
      is_periodic_{repeats_along(box, 0), repeats_along(box, 1), repeats_along(box, 2)} {
  if (box.tilted_edges.size() == 3)
    std::copy(box.tilted_edges.begin(), box.tilted_edges.end(), edges_.begin());
  prepare();
}

void PeriodicCell::prepare() {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 normal = cross(edges_[(k + 1) % 3], edges_[(k + 2) % 3]);
    const double six_faces = dot(normal, edges_[k]);
    if (!(std::abs(six_faces) > 0.0)) {
      if (is_periodic())
        throw InputError("the periodic box has no volume");
      return;
    }
    reciprocal_[k] = (1.0 / six_faces) * normal;
  }
  if (!is_tilted())
    return;
  for (int i = is_periodic_[0] ? -1 : 0; i <= (is_periodic_[0] ? 1 : 0); ++i)
    for (int j = is_periodic_[1] ? -1 : 0; j <= (is_periodic_[1] ? 1 : 0); ++j)
      for (int k = is_periodic_[2] ? -1 : 0; k <= (is_periodic_[2] ? 1 : 0); ++k)
        neighbours_.push_back(double(i) * edges_[0] + double(j) * edges_[1] +
                              double(k) * edges_[2]);
}

bool PeriodicCell::is_tilted() const {
  return edges_[0].y != 0.0 || edges_[0].z != 0.0 || edges_[1].x != 0.0 || edges_[1].z != 0.0 ||
         edges_[2].x != 0.0 || edges_[2].y != 0.0;
}

double PeriodicCell::volume() const { return dot(edges_[0], cross(edges_[1], edges_[2])); }

double PeriodicCell::thickness(std::size_t k) const { return 1.0 / norm(reciprocal_[k]); }

Vector3 PeriodicCell::fractions(const Vector3& point) const {
  const Vector3 d = point - corner_;
  return {dot(reciprocal_[0], d), dot(reciprocal_[1], d), dot(reciprocal_[2], d)};
}

double PeriodicCell::distance_beyond(const Vector3& point) const {
  const Vector3 f = fractions(point);
  const std::array<double, 3> shares{f.x, f.y, f.z};
  double farthest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    if (is_periodic_[k])
      farthest = std::max({farthest, -shares[k] * thickness(k), (shares[k] - 1.0) * thickness(k)});
  return farthest;
}

Vector3 PeriodicCell::wrapped(const Vector3& point) const {
  const Vector3 f = fractions(point);
  const std::array<double, 3> shares{f.x, f.y, f.z};
  Vector3 result = point;
  for (std::size_t k = 0; k < 3; ++k)
    if (is_periodic_[k])
      result -= std::floor(shares[k]) * edges_[k];
  return result;
}

Vector3 PeriodicCell::nearest(const Vector3& distance) const {
  Vector3 result = distance;
  for (std::size_t k = 0; k < 3; ++k)
    if (is_periodic_[k])
      result -= std::round(dot(reciprocal_[k], distance)) * edges_[k];
  for (bool is_shorter = !neighbours_.empty(); is_shorter;) {
    is_shorter = false;
    for (const Vector3& shift : neighbours_) {
      const Vector3 image = result + shift;
      constexpr double beyond_rounding = 1.0 - 1.0e-14;
      if (dot(image, image) < beyond_rounding * dot(result, result)) {
        result = image;
        is_shorter = true;
      }
    }
  }
  return result;
}

std::vector<Vector3> PeriodicCell::shifts(double reach) const {
  constexpr double most_images = 1.0e5;
  double count = 1.0;
  for (std::size_t k = 0; k < 3; ++k)
    count *= is_periodic_[k] ? 2.0 * std::ceil(reach / thickness(k)) + 1.0 : 1.0;
  if (!(count <= most_images))
    throw InputError(fmt::format("{:.3g} images of the box that repeats come within {:.3g} of it "
                                 "(at most {:.0e} are taken): a body or width is far larger than "
                                 "the box; --periodic none takes no images",
                                 count, reach, most_images));
  std::array<int, 3> most{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k)
    if (is_periodic_[k])
      most[k] = static_cast<int>(std::ceil(reach / thickness(k)));
  std::vector<Vector3> result{Vector3{}};
  for (int i = -most[0]; i <= most[0]; ++i)
    for (int j = -most[1]; j <= most[1]; ++j)
      for (int k = -most[2]; k <= most[2]; ++k)
        if (i != 0 || j != 0 || k != 0)
          result.push_back(double(i) * edges_[0] + double(j) * edges_[1] + double(k) * edges_[2]);
  return result;
}

} // namespace ellipsoid::post
