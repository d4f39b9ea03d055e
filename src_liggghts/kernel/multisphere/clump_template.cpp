// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/clump_template.h"

#include "multisphere/union_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

namespace ellipsoid {
namespace {

constexpr double same_sphere = 1e-9; ///< relative to the size: lists have 12 digits and more
constexpr double same_shape = 1e-5;  ///< relative: semi-axes written with six digits
constexpr double same_frame = 1e-6;  ///< relative: lists written with six digits

double trace(const SymmetricMatrix3& m) { return m.xx + m.yy + m.zz; }

double largest_product(const SymmetricMatrix3& inertia) {
  return std::max({std::fabs(inertia.xy), std::fabs(inertia.xz), std::fabs(inertia.yz)});
}

/// Jacobi's rotations. @return the principal axes, columns in the order of ascending moments
Rotation3 principal_axes(const SymmetricMatrix3& inertia, Vector3& moments) {
  double m[3][3] = {{inertia.xx, inertia.xy, inertia.xz},
                    {inertia.xy, inertia.yy, inertia.yz},
                    {inertia.xz, inertia.yz, inertia.zz}};
  std::array<Vector3, 3> axes{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
  constexpr int sweeps = 12; // converges quadratically
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
      const double angle = 0.5 * std::atan2(2.0 * m[p][q], m[p][p] - m[q][q]);
      const double c = std::cos(angle), s = std::sin(angle);
      for (auto& row : m)
        std::tie(row[p], row[q]) = std::make_pair(c * row[p] + s * row[q], c * row[q] - s * row[p]);
      for (std::size_t k = 0; k < 3; ++k)
        std::tie(m[p][k], m[q][k]) =
            std::make_pair(c * m[p][k] + s * m[q][k], c * m[q][k] - s * m[p][k]);
      std::tie(axes[p], axes[q]) =
          std::make_pair(c * axes[p] + s * axes[q], c * axes[q] - s * axes[p]);
    }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&m](std::size_t k, std::size_t l) { return m[k][k] < m[l][l]; });
  moments = {m[order[0]][order[0]], m[order[1]][order[1]], m[order[2]][order[2]]};
  return {axes[order[0]], axes[order[1]], axes[order[2]]};
}

/// Whether an axis has to be turned round for the farthest sphere to lie on its positive side.
bool points_away(const SphereSet& set, const Vector3& axis) {
  double farthest = 0.0;
  constexpr double clearly = 1.0 + 1e-6; // of two equal ones that which comes first
  for (const Vector3& centre : set.centres)
    if (std::fabs(dot(centre, axis)) > clearly * std::fabs(farthest))
      farthest = dot(centre, axis);
  return farthest < 0.0;
}

/// Turns a set about its centre of mass to its principal axes. @return its moments there
Vector3 turn_to_principal_axes(const SymmetricMatrix3& inertia, SphereSet& set) {
  if (largest_product(inertia) <= principal_rounding * trace(inertia))
    return {inertia.xx, inertia.yy, inertia.zz};
  Vector3 moments;
  Rotation3 axes = principal_axes(inertia, moments);
  for (Vector3* axis : {&axes.column_x, &axes.column_y})
    if (points_away(set, *axis))
      *axis = -*axis;
  axes.column_z = cross(axes.column_x, axes.column_y);
  for (Vector3& centre : set.centres)
    centre = axes.to_body(centre);
  return moments;
}

/// Fills what follows from the spheres in the body's frame.
void measure_extent(ClumpTemplate& clump) {
  SphereSet& set = clump.spheres;
  for (std::size_t k = 0; k < set.centres.size(); ++k) {
    const Vector3& c = set.centres[k];
    const double r = set.radii[k];
    clump.semiaxes = {std::max(clump.semiaxes.x, std::fabs(c.x) + r),
                      std::max(clump.semiaxes.y, std::fabs(c.y) + r),
                      std::max(clump.semiaxes.z, std::fabs(c.z) + r)};
    clump.bounding_radius = std::max(clump.bounding_radius, norm(c) + r);
  }
  for (Vector3& centre : set.centres)
    centre *= 1.0 / clump.semiaxes.y;
  for (double& radius : set.radii)
    radius /= clump.semiaxes.y;
}

} // namespace

ClumpTemplate make_clump(const SphereList& list) {
  check_values(list.spheres);
  check_connected(list.spheres);
  ClumpTemplate clump;
  clump.spheres = list.spheres;
  clump.equal_spheres = leave_out_equal_spheres(clump.spheres);
  const UnionMeasures measures = measure_union(clump.spheres);
  clump.volume = measures.volume;
  clump.surface = measures.surface;
  if (list.is_body_frame) {
    clump.moments = {measures.inertia.xx, measures.inertia.yy, measures.inertia.zz};
    clump.is_principal = norm(measures.centre) <= same_frame * std::cbrt(measures.volume) &&
                         largest_product(measures.inertia) <= same_frame * trace(measures.inertia);
  } else {
    const double size = std::cbrt(measures.volume);
    if (norm(measures.centre) > principal_rounding * size)
      for (Vector3& centre : clump.spheres.centres)
        centre -= measures.centre;
    clump.moments = turn_to_principal_axes(measures.inertia, clump.spheres);
  }
  measure_extent(clump);
  return clump;
}

bool are_same(const ClumpTemplate& first, const ClumpTemplate& second) {
  const SphereSet &a = first.spheres, &b = second.spheres;
  if (a.centres.size() != b.centres.size() ||
      norm(first.semiaxes - second.semiaxes) > same_sphere * first.bounding_radius)
    return false;
  const double largest = same_sphere * first.bounding_radius / first.semiaxes.y;
  for (std::size_t k = 0; k < a.centres.size(); ++k)
    if (norm(a.centres[k] - b.centres[k]) > largest || std::fabs(a.radii[k] - b.radii[k]) > largest)
      return false;
  return true;
}

bool has_shape_of(const ClumpTemplate& clump, const Vector3& semiaxes) {
  const double size = semiaxes.y / clump.semiaxes.y;
  return norm(semiaxes - size * clump.semiaxes) <= same_shape * size * clump.bounding_radius;
}

} // namespace ellipsoid
