// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/ellipsoid_spheres.h"

#include "multisphere/medial_spheres.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace ellipsoid {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("multisphere template: " + what);
}

std::string text_of(const Vector3& semiaxes) {
  char text[96];
  std::snprintf(text, sizeof text, "%.6g %.6g %.6g", semiaxes.x, semiaxes.y, semiaxes.z);
  return text;
}

void check_semiaxes(const Vector3& semiaxes) {
  for (const double axis : {semiaxes.x, semiaxes.y, semiaxes.z})
    if (!std::isfinite(axis) || !(axis > 0.0))
      refuse("semi-axes " + text_of(semiaxes) + "; three finite values > 0 are needed");
  const double ratio = std::max({semiaxes.x, semiaxes.y, semiaxes.z}) /
                       std::min({semiaxes.x, semiaxes.y, semiaxes.z});
  if (!(ratio >= smallest_aspect_ratio && ratio <= largest_aspect_ratio))
    refuse("semi-axes " + text_of(semiaxes) +
           "; the largest may be 1.000001 to 100 times the smallest: change them, or use a sphere");
}

void check_count(int count, SphereSpacing spacing) {
  const int largest = largest_count_of(spacing);
  if (count >= 1 && count <= largest)
    return;
  refuse("number of sub-spheres N = " + std::to_string(count) + "; with spacing " +
         word_of(spacing) + " 1 to " + std::to_string(largest) +
         " are allowed: choose a number in this range");
}

/// Places of the semi-axes in descending order: which of x, y, z is a, b, c.
std::array<int, 3> descending(const Vector3& semiaxes) {
  const double axes[3] = {semiaxes.x, semiaxes.y, semiaxes.z};
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int k, int l) { return axes[k] > axes[l]; });
  return order;
}

/// All images in the body's frame; the second one of four lies opposite the first, so that a half
/// of them keeps the centre.
void append(SphereSet& set, const MirroredSphere& sphere, const std::array<int, 3>& order,
            double scale) {
  for (const int image : {0, 3, 1, 2}) {
    const bool at_left = image % 2 == 1, at_back = image / 2 == 1;
    if ((at_left && !(sphere.x > 0.0)) || (at_back && !(sphere.y > 0.0)))
      continue;
    double centre[3] = {0.0, 0.0, 0.0};
    centre[order[0]] = scale * (at_left ? -sphere.x : sphere.x);
    centre[order[1]] = scale * (at_back ? -sphere.y : sphere.y);
    set.centres.push_back({centre[0], centre[1], centre[2]});
    set.radii.push_back(scale * sphere.radius);
  }
}

SphereSet planar_set(const Vector3& semiaxes, int count, SphereSpacing spacing) {
  const std::array<int, 3> order = descending(semiaxes);
  const double axes[3] = {semiaxes.x, semiaxes.y, semiaxes.z};
  const double scale = axes[order[0]]; // solved for a = 1: no unit of length
  const SortedSemiaxes sorted{1.0, axes[order[1]] / scale, axes[order[2]] / scale};
  SphereSet set;
  for (const MirroredSphere& sphere : spacing == SphereSpacing::medial
                                          ? medial_levels(sorted, count)
                                          : minimax_volume_spheres(sorted, count))
    append(set, sphere, order, scale);
  set.centres.resize(static_cast<std::size_t>(count)); // of the last four
  set.radii.resize(static_cast<std::size_t>(count));
  return set;
}

/// Whether the centre lies in a sphere: sets without a sphere about it may leave it open.
bool holds_centre(const SphereSet& set) {
  for (std::size_t k = 0; k < set.radii.size(); ++k)
    if (norm(set.centres[k]) < set.radii[k])
      return true;
  return false;
}

/// Of the next levels of `medial` the first one that is one body; 0 if none.
int next_whole_level(const Vector3& semiaxes, int count) {
  const int most = largest_set_count - (largest_set_count - count) % 2;
  const int parity = count % 2;
  for (int last = std::min(2 * count + 64 + parity, most);;
       last = std::min(2 * last - parity, most)) {
    const SphereSet set = planar_set(semiaxes, last, SphereSpacing::medial);
    for (int n = connected_count(set, count + 2, 2); n > 0; n = connected_count(set, n + 2, 2)) {
      SphereSet level{set.centres, set.radii};
      level.centres.resize(static_cast<std::size_t>(n));
      level.radii.resize(static_cast<std::size_t>(n));
      if (holds_centre(level))
        return n;
    }
    if (last == most)
      return 0;
  }
}

/// A larger N of the same parity that gives one body, N - 2 does not; 0 if none was found.
int next_whole_count(const Vector3& semiaxes, int count, SphereSpacing spacing) {
  if (spacing == SphereSpacing::medial)
    return next_whole_level(semiaxes, count);
  const auto is_whole = [&](int n) { return is_one_body(planar_set(semiaxes, n, spacing)); };
  const int most = largest_count_of(spacing) - (largest_count_of(spacing) - count) % 2;
  int low = count, high = count;
  for (int step = 2; !(high > count && is_whole(high)); step *= 2) {
    if (high == most)
      return 0;
    low = high;
    high = std::min(high + step, most);
  }
  while (high - low > 2) {
    const int middle = low + (high - low) / 4 * 2;
    (is_whole(middle) ? high : low) = middle;
  }
  return high;
}

[[noreturn]] void refuse_apart(const Vector3& semiaxes, int count, SphereSpacing spacing) {
  const int enough = next_whole_count(semiaxes, count, spacing);
  refuse("with N = " + std::to_string(count) + " sub-spheres of spacing " + word_of(spacing) +
         " at semi-axes " + text_of(semiaxes) + " the spheres are not one body about the centre; " +
         (enough > 0 ? "N = " + std::to_string(enough) + " is enough"
                     : "no N up to " + std::to_string(largest_count_of(spacing)) +
                           " that was tried is enough: use a rounder body"));
}

} // namespace

bool is_one_body(const SphereSet& set) {
  const std::vector<int> parts = connected_parts(set);
  return *std::max_element(parts.begin(), parts.end()) == 0 && holds_centre(set);
}

int largest_count_of(SphereSpacing spacing) {
  return spacing == SphereSpacing::medial ? largest_set_count : largest_sphere_count;
}

SphereSet place_ellipsoid_spheres(const Vector3& semiaxes, int count, SphereSpacing spacing) {
  check_semiaxes(semiaxes);
  check_count(count, spacing);
  return planar_set(semiaxes, count, spacing);
}

SphereSet spheres_of(const MultisphereTemplate& chain) {
  SphereSet set;
  for (const double x : chain.centres)
    set.centres.push_back({x, 0.0, 0.0});
  set.radii = chain.radii;
  return set;
}

SphereSet make_ellipsoid_spheres(const Vector3& semiaxes, int count, SphereSpacing spacing) {
  if (is_planar(spacing)) {
    SphereSet set = place_ellipsoid_spheres(semiaxes, count, spacing);
    if (!is_one_body(set))
      refuse_apart(semiaxes, count, spacing);
    return set;
  }
  if (semiaxes.y != semiaxes.z)
    refuse("spacing " + word_of(spacing) + " with semi-axes " + text_of(semiaxes) +
           "; it needs b = c: use spacing medial or minimax_volume");
  return spheres_of(make_multisphere(semiaxes.x, semiaxes.y, count, spacing));
}

} // namespace ellipsoid
