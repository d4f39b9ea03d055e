// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "insertion/solid_body.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid {
namespace {

std::array<double, 3> components(const Vector3& v) { return {v.x, v.y, v.z}; }

/// Half lengths of the box around a smooth body: support along x, y, z.
std::array<double, 3> half_box(const EllipsoidShape& shape) {
  const SymmetricMatrix3& a = shape.a_matrix;
  return {std::sqrt(a.xx), std::sqrt(a.yy), std::sqrt(a.zz)};
}

/// Whether test(centre, radius) holds for all spheres of a body.
template <class Test> bool all_spheres(const SolidBody& body, const Test& test) {
  const SphereCentres spheres(body.spheres);
  for (int k = 0; k < body.spheres.body->count(); ++k)
    if (!test(body.centre + spheres.at(k), spheres.radius(k)))
      return false;
  return true;
}

/// Support of a smooth body along a vector, times the vector's length (length^2).
double support_times_length(const EllipsoidShape& shape, const Vector3& along) {
  return std::sqrt(dot(along, shape.a_matrix * along));
}

/// Of the largest ball about the centre within one of the spheres; 0: none has the centre.
double inscribed_radius(const MultispherePose& pose) {
  if (pose.body->is_chain()) // the middle one of an odd number
    return pose.scale * pose.body->radius(pose.body->count() / 2);
  double largest = 0.0;
  for (int k = 0; k < pose.body->count(); ++k)
    largest = std::max(largest, pose.body->radius(k) - norm(pose.body->centre(k)));
  return pose.scale * largest;
}

/// Of a body of spheres with a smooth one.
bool spheres_overlap(const SolidBody& spheres, const SolidBody& smooth) {
  if (smooth.inscribed_radius >= smooth.bounding_radius)
    return !all_spheres(spheres, [&smooth](const Vector3& centre, double radius) {
      return norm(smooth.centre - centre) > smooth.bounding_radius + radius;
    });
  return !all_spheres(spheres, [&smooth](const Vector3& centre, double radius) {
    const EllipsoidShape sphere = make_shape({radius, radius, radius}, {});
    return find_contact(sphere, smooth.shape, smooth.centre - centre).status ==
           ContactStatus::separated;
  });
}

/// A symmetric matrix of two rows turned to its principal axes: half the angle between them and the
/// coordinates' has the tangent 2 xy / (xx - yy).
struct PlaneEllipse {
  std::array<double, 2> squared, centre;

  PlaneEllipse(double xx, double yy, double xy, double x, double y) {
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy), c = std::cos(angle),
                 s = std::sin(angle);
    squared = {c * c * xx + 2.0 * c * s * xy + s * s * yy,
               s * s * xx - 2.0 * c * s * xy + c * c * yy};
    centre = {c * x + s * y, c * y - s * x};
  }
};

/// Jacobi's rotations bring the matrix of a smooth body to its principal axes; `offset` turns with
/// it.
void to_principal_axes(const SymmetricMatrix3& a, std::array<double, 3>& squared,
                       std::array<double, 3>& offset) {
  double m[3][3] = {{a.xx, a.xy, a.xz}, {a.xy, a.yy, a.yz}, {a.xz, a.yz, a.zz}};
  constexpr int sweeps = 12; // converges quadratically
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const auto& [p, q] : {std::pair<int, int>{0, 1}, {0, 2}, {1, 2}}) {
      const double angle = 0.5 * std::atan2(2.0 * m[p][q], m[p][p] - m[q][q]), c = std::cos(angle),
                   s = std::sin(angle);
      const auto turn = [c = c, s = s](double& x, double& y) {
        const double old = x;
        x = c * old + s * y;
        y = c * y - s * old;
      };
      for (auto& row : m)
        turn(row[p], row[q]);
      for (int k = 0; k < 3; ++k)
        turn(m[p][k], m[q][k]);
      turn(offset[static_cast<std::size_t>(p)], offset[static_cast<std::size_t>(q)]);
    }
  squared = {m[0][0], m[1][1], m[2][2]};
}

} // namespace

SolidBody smooth_body(const Vector3& centre, const Vector3& semiaxes,
                      const Quaternion& orientation) {
  return {centre,
          std::max({semiaxes.x, semiaxes.y, semiaxes.z}),
          std::min({semiaxes.x, semiaxes.y, semiaxes.z}),
          make_shape(semiaxes, orientation),
          {}};
}

SolidBody multisphere_body(const Vector3& centre, const MultispherePose& pose) {
  return {centre, pose.scale * pose.body->reach(), inscribed_radius(pose), {}, pose};
}

SolidBody inscribed_ball(const SolidBody& body) {
  const double r = body.inscribed_radius;
  return smooth_body(body.centre, {r, r, r}, {});
}

bool overlap(const SolidBody& i, const SolidBody& j) {
  const Vector3 distance = j.centre - i.centre;
  const double square = dot(distance, distance), reach = i.bounding_radius + j.bounding_radius;
  if (square > reach * reach)
    return false;
  const double within = i.inscribed_radius + j.inscribed_radius;
  if (square < within * within)
    return true;
  if (i.is_smooth() != j.is_smooth())
    return i.is_smooth() ? spheres_overlap(j, i) : spheres_overlap(i, j);
  if (i.is_smooth()) {
    // a plane across the line of centres parts them: the supports along it do not reach
    if (support_times_length(i.shape, distance) + support_times_length(j.shape, distance) < square)
      return false;
    return find_contact(i.shape, j.shape, distance).status != ContactStatus::separated;
  }
  bool touching = false;
  for_each_contact(i.spheres, j.spheres, distance,
                   [&touching](const SphereContact&) { touching = true; });
  return touching;
}

bool is_inside_block(const SolidBody& body, const std::array<double, 3>& low,
                     const std::array<double, 3>& high) {
  const auto is_inside = [&](const Vector3& centre, const std::array<double, 3>& half) {
    const std::array<double, 3> c = components(centre);
    for (std::size_t k = 0; k < 3; ++k)
      if (c[k] - half[k] < low[k] || c[k] + half[k] > high[k])
        return false;
    return true;
  };
  if (body.is_smooth())
    return is_inside(body.centre, half_box(body.shape));
  return all_spheres(body, [&](const Vector3& c, double r) { return is_inside(c, {r, r, r}); });
}

bool is_inside_ball(const SolidBody& body, const Vector3& centre, double radius) {
  if (!body.is_smooth())
    return all_spheres(body,
                       [&](const Vector3& c, double r) { return norm(c - centre) + r <= radius; });
  std::array<double, 3> squared, offset = components(body.centre - centre);
  to_principal_axes(body.shape.a_matrix, squared, offset);
  return farthest_squared_distance<3>(squared, offset) <= radius * radius;
}

bool is_inside_cylinder(const SolidBody& body, int axis, const Vector3& centre, double radius,
                        double low, double high) {
  const auto along = static_cast<std::size_t>(axis), first = (along + 1) % 3,
             second = (along + 2) % 3;
  const auto offset_of = [&](const Vector3& c) {
    const std::array<double, 3> offset = components(c - centre);
    return std::array<double, 2>{offset[first], offset[second]};
  };
  if (!body.is_smooth())
    return all_spheres(body, [&](const Vector3& c, double r) {
      const auto [u, v] = offset_of(c);
      const double height = components(c)[along];
      return height - r >= low && height + r <= high && std::hypot(u, v) + r <= radius;
    });
  const double half = half_box(body.shape)[along], height = components(body.centre)[along];
  if (height - half < low || height + half > high)
    return false;
  const SymmetricMatrix3& a = body.shape.a_matrix;
  const std::array<double, 3> diagonal{a.xx, a.yy, a.zz}, across{a.yz, a.xz, a.xy};
  const auto [u, v] = offset_of(body.centre);
  const PlaneEllipse shadow(diagonal[first], diagonal[second], across[along], u, v);
  return farthest_squared_distance<2>(shadow.squared, shadow.centre) <= radius * radius;
}

/// Any l above the largest squared semi-axis gives the upper bound l + sum l c^2 / (l - s); the
/// least of these is the largest distance squared (S-lemma), where their derivative vanishes.
template <std::size_t N>
double farthest_squared_distance(const std::array<double, N>& squared,
                                 const std::array<double, N>& centre) {
  const double longest = *std::max_element(squared.begin(), squared.end());
  double far = 0.0;
  for (const double c : centre)
    far += c * c;
  const auto falls = [&](double l) {
    double sum = 0.0;
    for (std::size_t k = 0; k < N; ++k)
      sum += squared[k] * centre[k] * centre[k] / ((l - squared[k]) * (l - squared[k]));
    return sum > 1.0;
  };
  constexpr double just_above = 1.0 + 1e-14;
  double low = longest * just_above, high = low + std::sqrt(longest * far);
  for (double middle = 0.5 * (low + high); middle > low && middle < high;
       middle = 0.5 * (low + high))
    (falls(middle) ? low : high) = middle;
  double bound = high;
  for (std::size_t k = 0; k < N; ++k)
    bound += high * centre[k] * centre[k] / (high - squared[k]);
  return bound;
}

template double farthest_squared_distance<2>(const std::array<double, 2>&,
                                             const std::array<double, 2>&);
template double farthest_squared_distance<3>(const std::array<double, 3>&,
                                             const std::array<double, 3>&);

} // namespace ellipsoid
