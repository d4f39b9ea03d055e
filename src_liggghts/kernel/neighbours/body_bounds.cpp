// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "neighbours/body_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ellipsoid {

namespace {

using Triple = std::array<double, 3>;

Triple triple(const Vector3& v) { return {v.x, v.y, v.z}; }

int largest_of(const Triple& values) {
  return static_cast<int>(std::max_element(values.begin(), values.end()) - values.begin());
}

} // namespace

BodyBounds bounds_of_ellipsoid(const Vector3& semiaxes) {
  const Triple axes = triple(semiaxes);
  BodyBounds bounds;
  bounds.semiaxes = semiaxes;
  bounds.capsule_axis = largest_of(axes);
  const auto longest = static_cast<std::size_t>(bounds.capsule_axis);
  bounds.capsule_radius = std::max(axes[(longest + 1) % 3], axes[(longest + 2) % 3]);
  bounds.half_length = axes[longest] - bounds.capsule_radius;
  bounds.turning_radius = turning_radius(axes[0], axes[1], axes[2]);
  return bounds;
}

double enlargement_for_ball(const Vector3& semiaxes, const Vector3& centre, double radius) {
  const Triple a = triple(semiaxes), c = triple(centre);
  const double shortest = *std::min_element(a.begin(), a.end());
  const double least = 1.0 / (shortest * shortest); // of the multiplier
  // how far the ball's farthest point for a multiplier is, squared, less the radius squared
  const auto excess = [&](double multiplier) {
    double sum = -radius * radius;
    for (std::size_t k = 0; k < 3; ++k) {
      const double share = c[k] / (multiplier * a[k] * a[k] - 1.0);
      sum += c[k] == 0.0 ? 0.0 : share * share;
    }
    return sum;
  };
  double low = least, high = least * (1.0 + norm(centre) / radius);
  for (int step = 0; step < 60 && low < high; ++step) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  double squared = high * radius * radius;
  for (std::size_t k = 0; k < 3; ++k)
    squared += c[k] == 0.0 ? 0.0 : c[k] * c[k] * high / (high * a[k] * a[k] - 1.0);
  return (1.0 + 1e-12) * std::sqrt(squared);
}

BodyBounds bounds_of_spheres(const std::vector<Vector3>& centres,
                             const std::vector<double>& radii) {
  Triple reach{0.0, 0.0, 0.0};
  double farthest = 0.0;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const Triple centre = triple(centres[k]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      reach[axis] = std::max(reach[axis], std::fabs(centre[axis]) + radii[k]);
    farthest = std::max(farthest, norm(centres[k]));
  }
  const int longest = largest_of(reach);
  const auto along = [longest](const Vector3& centre) {
    return triple(centre)[static_cast<std::size_t>(longest)];
  };
  const auto aside = [&along](const Vector3& centre) {
    return std::sqrt(std::fmax(0.0, dot(centre, centre) - along(centre) * along(centre)));
  };
  BodyBounds bounds;
  bounds.capsule_axis = longest;
  bounds.turning_radius = farthest;
  double factor = 0.0;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    bounds.capsule_radius = std::max(bounds.capsule_radius, aside(centres[k]) + radii[k]);
    factor = std::max(factor,
                      enlargement_for_ball({reach[0], reach[1], reach[2]}, centres[k], radii[k]));
  }
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const double room = bounds.capsule_radius - radii[k], off = aside(centres[k]);
    bounds.half_length =
        std::max(bounds.half_length,
                 std::fabs(along(centres[k])) - std::sqrt(std::fmax(0.0, room * room - off * off)));
  }
  bounds.semiaxes = factor * Vector3{reach[0], reach[1], reach[2]};
  return bounds;
}

BodyBounds scaled(const BodyBounds& bounds, double factor) {
  return {factor * bounds.semiaxes, bounds.capsule_axis, factor * bounds.half_length,
          factor * bounds.capsule_radius, factor * bounds.turning_radius};
}

} // namespace ellipsoid
