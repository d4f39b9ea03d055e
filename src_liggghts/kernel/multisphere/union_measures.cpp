// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/union_measures.h"

#include "multisphere/sphere_patch.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace ellipsoid {
namespace {

/// For each sphere the others that overlap or hold it, in ascending order: a sweep along x.
std::vector<std::vector<std::size_t>> overlapping(const SphereSet& set) {
  std::vector<std::size_t> order(set.radii.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto begin_of = [&](std::size_t k) { return set.centres[k].x - set.radii[k]; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t k, std::size_t l) { return begin_of(k) < begin_of(l); });
  std::vector<std::vector<std::size_t>> neighbours(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t k = order[i];
    const double end = set.centres[k].x + set.radii[k];
    for (std::size_t j = i + 1; j < order.size() && begin_of(order[j]) < end; ++j) {
      const std::size_t l = order[j];
      const Vector3 apart = set.centres[l] - set.centres[k];
      const double reach = set.radii[k] + set.radii[l];
      if (dot(apart, apart) < reach * reach) {
        neighbours[k].push_back(l);
        neighbours[l].push_back(k);
      }
    }
  }
  for (std::vector<std::size_t>& of_one : neighbours)
    std::sort(of_one.begin(), of_one.end());
  return neighbours;
}

/// Caps of sphere k that lie in others; nothing if another one covers it all. Of equal spheres the
/// first one counts.
std::optional<std::vector<SphereCap>> caps_of(const SphereSet& set, std::size_t k,
                                              const std::vector<std::size_t>& neighbours) {
  std::vector<SphereCap> caps;
  const double radius = set.radii[k];
  for (const std::size_t l : neighbours) {
    const Vector3 apart = set.centres[l] - set.centres[k];
    const double distance = norm(apart), other = set.radii[l];
    if (distance == 0.0) {
      if (other > radius || (other == radius && l < k))
        return std::nullopt;
      continue;
    }
    // of the plane in which the two cut each other
    const double height =
        0.5 * (distance + (radius - other) * (radius + other) / distance) / radius;
    if (height <= -1.0)
      return std::nullopt;
    if (height < 1.0)
      caps.push_back({(1.0 / distance) * apart, height});
  }
  return caps;
}

/// Integrals over the union of 1, x and x x about an origin, and its surface.
struct Moments {
  double surface = 0.0, volume = 0.0;
  Vector3 first;
  SymmetricMatrix3 second;
};

SymmetricMatrix3 dyad(const Vector3& a, const Vector3& b) { ///< (a b + b a) / 2
  return {a.x * b.x,
          a.y * b.y,
          a.z * b.z,
          0.5 * (a.x * b.y + a.y * b.x),
          0.5 * (a.x * b.z + a.z * b.x),
          0.5 * (a.y * b.z + a.z * b.y)};
}

/// One sphere's part of the surface integrals x.n / 3, x^2 n / 2 and x x (x.n) / 5, x = c + r n.
void add_patch(Moments& sum, const Vector3& c, double r, const PatchIntegrals& patch) {
  const double area = r * r;
  const Vector3 second_c = patch.second * c;
  const SymmetricMatrix3 third_c =
      c.x * patch.third[0] + c.y * patch.third[1] + c.z * patch.third[2];
  const double flux = dot(c, patch.first) + r * patch.solid_angle;
  sum.surface += area * patch.solid_angle;
  sum.volume += area / 3.0 * flux;
  sum.first += 0.5 * area * ((dot(c, c) + r * r) * patch.first + 2.0 * r * second_c);
  sum.second = sum.second + 0.2 * area *
                                (flux * dyad(c, c) + 2.0 * r * dyad(c, second_c + r * patch.first) +
                                 r * r * (third_c + r * patch.second));
}

Vector3 mean_centre(const SphereSet& set) {
  Vector3 sum;
  for (const Vector3& centre : set.centres)
    sum += centre;
  return (1.0 / set.count()) * sum;
}

} // namespace

UnionMeasures measure_union(const SphereSet& set) {
  check_spheres(set);
  const Vector3 origin = mean_centre(set);
  const std::vector<std::vector<std::size_t>> neighbours = overlapping(set);
  Moments moments;
  for (std::size_t k = 0; k < neighbours.size(); ++k)
    if (auto caps = caps_of(set, k, neighbours[k]))
      add_patch(moments, set.centres[k] - origin, set.radii[k], uncovered_patch(std::move(*caps)));
  const Vector3 centre = (1.0 / moments.volume) * moments.first;
  const SymmetricMatrix3 about_centre = moments.second + -moments.volume * dyad(centre, centre);
  const double trace = about_centre.xx + about_centre.yy + about_centre.zz;
  return {moments.volume, moments.surface, origin + centre,
          SymmetricMatrix3{trace, trace, trace, 0.0, 0.0, 0.0} + -1.0 * about_centre};
}

} // namespace ellipsoid
