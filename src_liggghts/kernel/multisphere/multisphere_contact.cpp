// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/multisphere_contact.h"

#include <algorithm>

namespace ellipsoid {
namespace multisphere_search {
namespace {

/// Keeps those x for which |offset + slope x| <= bound.
void clip_linear(Interval& interval, double offset, double slope, double bound, double extent) {
  if (std::fabs(slope) < search_smallest_slope) {
    if (std::fabs(offset) > bound + search_smallest_slope * extent)
      interval.high = -2.0 * extent;
    return;
  }
  const double middle = -offset / slope;
  const double width = bound / std::fabs(slope) + search_interval_rounding * extent;
  interval.clip(middle - width, middle + width);
}

/// Keeps those x for which squared + 2 linear x + quadratic x^2 <= bound^2.
void clip_line_distance(OuterLine& line, double bound) {
  if (line.quadratic < search_smallest_slope)
    return; // near parallel
  const double discriminant = line.linear * line.linear -
                              line.quadratic * (line.squared - bound * bound) +
                              search_rounding * line.extent * line.extent;
  const double middle = -line.linear / line.quadratic;
  const double width = std::sqrt(std::fmax(0.0, discriminant)) / line.quadratic +
                       search_interval_rounding * line.extent;
  line.centres.clip(middle - width, middle + width);
}

} // namespace

OuterLine outer_line(const MultispherePose& outer, const MultispherePose& inner,
                     const Vector3& outer_position, double gap) {
  const double outer_half = outer.scale * outer.body->half_length();
  const double inner_half = inner.scale * inner.body->half_length();
  const double radii =
      outer.scale * outer.body->largest_radius() + inner.scale * inner.body->largest_radius() + gap;
  const double along_outer = dot(outer_position, outer.axis);
  OuterLine line;
  line.offset = dot(outer_position, inner.axis);
  line.slope = dot(outer.axis, inner.axis);
  const double squared_distance = dot(outer_position, outer_position);
  line.squared = squared_distance - line.offset * line.offset;
  line.linear = along_outer - line.slope * line.offset;
  line.quadratic = 1.0 - line.slope * line.slope;
  const double reach = outer_half + inner_half + radii;
  line.extent = 2.0 * reach;
  line.centres = {-line.extent, line.extent};
  if (!(squared_distance <= reach * reach * (1.0 + search_rounding))) {
    line.centres.high = -2.0 * line.extent; // beyond each other's bounding spheres
    return line;
  }
  // Along the inner axis, then along the outer axis, then across the inner axis.
  clip_linear(line.centres, line.offset, line.slope, inner_half + radii, line.extent);
  clip_linear(line.centres, along_outer, 1.0, std::fabs(line.slope) * inner_half + radii,
              line.extent);
  clip_line_distance(line, radii);
  return line;
}

RelativePose relative_pose(const MultispherePose& i, const MultispherePose& j,
                           const Vector3& centre_distance) {
  const Rotation3 of_i = orientation_of(i), of_j = orientation_of(j);
  const double inverse = 1.0 / i.scale, ratio = j.scale * inverse;
  return {inverse * of_i.to_body(centre_distance), ratio * of_i.to_body(of_j.column_x),
          ratio * of_i.to_body(of_j.column_y), ratio * of_i.to_body(of_j.column_z), ratio};
}

} // namespace multisphere_search

double smallest_gap(const MultispherePose& i, const MultispherePose& j,
                    const Vector3& centre_distance) {
  if (!i.body->is_chain() || !j.body->is_chain()) {
    const SphereTree::Node &root_i = i.body->tree().node(0), &root_j = j.body->tree().node(0);
    const Vector3 way = centre_distance + (j.scale * orientation_of(j).to_space(root_j.centre) -
                                           i.scale * orientation_of(i).to_space(root_i.centre));
    const double radii = i.scale * root_i.radius + j.scale * root_j.radius;
    return norm(way) - radii - search_rounding * radii;
  }
  const double half_i = i.scale * i.body->half_length();
  const double half_j = j.scale * j.body->half_length();
  const Vector3 normal = cross(i.axis, j.axis);
  const double cosine = dot(i.axis, j.axis), sine_squared = dot(normal, normal);
  const double along_i = dot(centre_distance, i.axis), along_j = dot(centre_distance, j.axis);
  // Nearest points of two segments (Ericson, Real-Time Collision Detection, 5.1.9): nearest points
  // of the lines, clamped to one segment, then to the other, then back. An error e of x near
  // parallel axes changes the squared distance by sine_squared e^2 only.
  double x = sine_squared > 0.0
                 ? std::clamp((along_i - cosine * along_j) / sine_squared, -half_i, half_i)
                 : 0.0;
  const double y = std::clamp(cosine * x - along_j, -half_j, half_j);
  x = std::clamp(along_i + cosine * y, -half_i, half_i);
  const double axes = norm(centre_distance + (y * j.axis - x * i.axis));
  const double radii = i.scale * i.body->largest_radius() + j.scale * j.body->largest_radius();
  return axes - radii - search_rounding * (half_i + half_j + radii);
}

double nearest_gap(const MultispherePose& i, const MultispherePose& j,
                   const Vector3& centre_distance, double limit, int& tested) {
  double nearest = limit;
  if (i.body->is_chain() && j.body->is_chain()) {
    tested += for_each_near_pair(i, j, centre_distance, limit, [&](int, int, double overlap) {
      nearest = std::fmin(nearest, -overlap);
    });
    return nearest;
  }
  double within = limit / i.scale; // becomes smaller with every nearer pair
  tested += for_each_pair_within(i.body->tree(), j.body->tree(),
                                 multisphere_search::relative_pose(i, j, centre_distance), within,
                                 [&](int, int, double gap) { within = std::fmin(within, gap); });
  return i.scale * within;
}

} // namespace ellipsoid
