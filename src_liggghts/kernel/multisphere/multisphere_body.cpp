// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/multisphere_body.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

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

/// Whether the way from the origin to a point is covered by spheres.
bool is_covered(const std::vector<Vector3>& centres, const std::vector<double>& radii,
                const Vector3& to) {
  const double length = norm(to);
  std::vector<std::pair<double, double>> covered; // of the way, by one sphere each
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const double along = length > 0.0 ? dot(centres[k], to) / length : 0.0;
    const double half_squared =
        radii[k] * radii[k] - std::fmax(0.0, dot(centres[k], centres[k]) - along * along);
    if (half_squared > 0.0)
      covered.emplace_back(along - std::sqrt(half_squared), along + std::sqrt(half_squared));
  }
  std::sort(covered.begin(), covered.end());
  double reached = 0.0;
  for (const auto& [begin, end] : covered)
    if (begin <= reached)
      reached = std::fmax(reached, end);
  return reached >= length && !covered.empty() && covered.front().first <= 0.0;
}

} // namespace

MultisphereBody::MultisphereBody(const MultisphereTemplate& geometry)
    : abscissae_(geometry.centres), radii_(geometry.radii) {
  check(geometry);
  for (const double x : abscissae_)
    centres_.push_back({x, 0.0, 0.0});
  for (int k = 1; k < count(); ++k) {
    const double slope = (radius(k) - radius(k - 1)) / (abscissa(k) - abscissa(k - 1));
    steepest_radius_ = std::fmax(steepest_radius_, std::fabs(slope));
  }
  seen_.assign(radii_.size(), true);
  measure();
}

MultisphereBody::MultisphereBody(const SphereSet& set) : radii_(set.radii), centres_(set.centres) {
  check_spheres(set);
  for (const Vector3& centre : centres_)
    seen_.push_back(is_covered(centres_, radii_, centre));
  measure();
}

void MultisphereBody::measure() {
  for (int k = 0; k < count(); ++k) {
    const double distance = is_chain() ? std::fabs(abscissa(k)) : norm(centre(k));
    half_length_ = std::fmax(half_length_, distance);
    reach_ = std::fmax(reach_, distance + radius(k));
    largest_radius_ = std::fmax(largest_radius_, radius(k));
  }
  tree_ = SphereTree(centres_, radii_);
  bounds_ = bounds_of_spheres(centres_, radii_);
}

int MultisphereBody::first_at_or_after(double x) const {
  return static_cast<int>(std::lower_bound(abscissae_.begin(), abscissae_.end(), x) -
                          abscissae_.begin());
}

Vector3 normal_across(const Vector3& axis) {
  return normalized(
      cross(axis, std::fabs(axis.x) < 0.5 ? Vector3{1.0, 0.0, 0.0} : Vector3{0.0, 1.0, 0.0}));
}

double largest_reach(const MultispherePose& pose, const Vector3& direction) {
  const MultisphereBody& body = *pose.body;
  if (!body.is_chain())
    return pose.scale * body.reach();
  return pose.scale *
         (std::fabs(dot(pose.axis, direction)) * body.half_length() + body.largest_radius());
}

} // namespace ellipsoid
