// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/multisphere_contact.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace ellipsoid {
namespace {

[[noreturn]] void refuse(std::size_t sphere, const char* what) {
  throw std::invalid_argument("sphere chain: " + std::string(what) + " at sphere " +
                              std::to_string(sphere) + ": use a chain made by make_multisphere()");
}

void check(const MultisphereTemplate& geometry) {
  const std::vector<double>&x = geometry.centres, &r = geometry.radii;
  if (x.empty() || x.size() != r.size())
    refuse(0, "no sphere, or as many radii as centres needed");
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!std::isfinite(x[k]) || !std::isfinite(r[k]) || !(r[k] > 0.0))
      refuse(k, "finite centres and positive radii are needed");
    if (k > 0 && !(x[k] > x[k - 1]))
      refuse(k, "centres must ascend");
  }
  const double tolerance = concavity_rounding * *std::max_element(r.begin(), r.end());
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const double share = (x[k] - x[k - 1]) / (x[k + 1] - x[k - 1]);
    if (r[k] < r[k - 1] + share * (r[k + 1] - r[k - 1]) - tolerance)
      refuse(k, "radii must be a concave function of the centres");
  }
}

} // namespace

SphereChain::SphereChain(const MultisphereTemplate& geometry)
    : centres_(geometry.centres), radii_(geometry.radii) {
  check(geometry);
  for (int k = 0; k < count(); ++k) {
    half_length_ = std::fmax(half_length_, std::fabs(centre(k)));
    largest_radius_ = std::fmax(largest_radius_, radius(k));
    if (k == 0)
      continue;
    const double slope = (radius(k) - radius(k - 1)) / (centre(k) - centre(k - 1));
    steepest_radius_ = std::fmax(steepest_radius_, std::fabs(slope));
  }
}

int SphereChain::first_at_or_after(double x) const {
  return static_cast<int>(std::lower_bound(centres_.begin(), centres_.end(), x) - centres_.begin());
}

Vector3 normal_across(const Vector3& axis) {
  return normalized(
      cross(axis, std::fabs(axis.x) < 0.5 ? Vector3{1.0, 0.0, 0.0} : Vector3{0.0, 1.0, 0.0}));
}

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

OuterLine outer_line(const ChainPose& outer, const ChainPose& inner, const Vector3& outer_position,
                     double gap) {
  const double outer_half = outer.scale * outer.chain->half_length();
  const double inner_half = inner.scale * inner.chain->half_length();
  const double radii = outer.scale * outer.chain->largest_radius() +
                       inner.scale * inner.chain->largest_radius() + gap;
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

} // namespace multisphere_search

ContactCount find_contacts(const ChainPose& i, const ChainPose& j, const Vector3& centre_distance,
                           std::vector<SphereContact>& contacts) {
  contacts.clear();
  return for_each_contact(i, j, centre_distance,
                          [&](const SphereContact& contact) { contacts.push_back(contact); });
}

double smallest_gap(const ChainPose& i, const ChainPose& j, const Vector3& centre_distance) {
  const double half_i = i.scale * i.chain->half_length();
  const double half_j = j.scale * j.chain->half_length();
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
  const double radii = i.scale * i.chain->largest_radius() + j.scale * j.chain->largest_radius();
  return axes - radii - search_rounding * (half_i + half_j + radii);
}

} // namespace ellipsoid
