// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "periodic_cell.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

bool repeats_along(const Box& box, std::size_t k) {
  const std::string& words = box.boundary; // "pp pp ff"
  return words.size() >= 3 * k + 2 && words[3 * k] == 'p' && words[3 * k + 1] == 'p';
}

} // namespace

PeriodicCell::PeriodicCell(const Vector3& corner, const std::array<Vector3, 3>& edges,
                           const std::array<bool, 3>& is_periodic)
    : m_corner(corner), m_edges(edges), m_is_periodic(is_periodic) {
  prepare();
}

PeriodicCell::PeriodicCell(const Box& box)
    : m_corner{box.lower[0], box.lower[1], box.lower[2]},
      m_edges{Vector3{box.upper[0] - box.lower[0], 0.0, 0.0},
              Vector3{0.0, box.upper[1] - box.lower[1], 0.0},
              Vector3{0.0, 0.0, box.upper[2] - box.lower[2]}},
      m_is_periodic{repeats_along(box, 0), repeats_along(box, 1), repeats_along(box, 2)} {
  if (box.tilted_edges.size() == 3)
    std::copy(box.tilted_edges.begin(), box.tilted_edges.end(), m_edges.begin());
  prepare();
}

void PeriodicCell::prepare() {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 normal = cross(m_edges[(k + 1) % 3], m_edges[(k + 2) % 3]);
    const double six_faces = dot(normal, m_edges[k]);
    if (!(std::abs(six_faces) > 0.0)) {
      if (is_periodic())
        throw InputError("the periodic box has no volume");
      return;
    }
    m_reciprocal[k] = (1.0 / six_faces) * normal;
  }
  if (!is_tilted())
    return;
  for (int i = m_is_periodic[0] ? -1 : 0; i <= (m_is_periodic[0] ? 1 : 0); ++i)
    for (int j = m_is_periodic[1] ? -1 : 0; j <= (m_is_periodic[1] ? 1 : 0); ++j)
      for (int k = m_is_periodic[2] ? -1 : 0; k <= (m_is_periodic[2] ? 1 : 0); ++k)
        m_neighbours.push_back(double(i) * m_edges[0] + double(j) * m_edges[1] +
                               double(k) * m_edges[2]);
}

bool PeriodicCell::is_tilted() const {
  return m_edges[0].y != 0.0 || m_edges[0].z != 0.0 || m_edges[1].x != 0.0 || m_edges[1].z != 0.0 ||
         m_edges[2].x != 0.0 || m_edges[2].y != 0.0;
}

double PeriodicCell::volume() const { return dot(m_edges[0], cross(m_edges[1], m_edges[2])); }

double PeriodicCell::thickness(std::size_t k) const { return 1.0 / norm(m_reciprocal[k]); }

Vector3 PeriodicCell::fractions(const Vector3& point) const {
  const Vector3 d = point - m_corner;
  return {dot(m_reciprocal[0], d), dot(m_reciprocal[1], d), dot(m_reciprocal[2], d)};
}

double PeriodicCell::distance_beyond(const Vector3& point) const {
  const Vector3 f = fractions(point);
  const std::array<double, 3> shares{f.x, f.y, f.z};
  double farthest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    if (m_is_periodic[k])
      farthest = std::max({farthest, -shares[k] * thickness(k), (shares[k] - 1.0) * thickness(k)});
  return farthest;
}

Vector3 PeriodicCell::wrapped(const Vector3& point) const {
  const Vector3 f = fractions(point);
  const std::array<double, 3> shares{f.x, f.y, f.z};
  Vector3 result = point;
  for (std::size_t k = 0; k < 3; ++k)
    if (m_is_periodic[k])
      result -= std::floor(shares[k]) * m_edges[k];
  return result;
}

Vector3 PeriodicCell::nearest(const Vector3& distance) const {
  Vector3 result = distance;
  for (std::size_t k = 0; k < 3; ++k)
    if (m_is_periodic[k])
      result -= std::round(dot(m_reciprocal[k], distance)) * m_edges[k];
  for (bool is_shorter = !m_neighbours.empty(); is_shorter;) {
    is_shorter = false;
    for (const Vector3& shift : m_neighbours) {
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
  std::array<int, 3> most{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k)
    if (m_is_periodic[k])
      most[k] = static_cast<int>(std::ceil(reach / thickness(k)));
  std::vector<Vector3> result{Vector3{}};
  for (int i = -most[0]; i <= most[0]; ++i)
    for (int j = -most[1]; j <= most[1]; ++j)
      for (int k = -most[2]; k <= most[2]; ++k)
        if (i != 0 || j != 0 || k != 0)
          result.push_back(double(i) * m_edges[0] + double(j) * m_edges[1] +
                           double(k) * m_edges[2]);
  return result;
}

} // namespace ellipsoid::post
