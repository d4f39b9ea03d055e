// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/multisphere_template.h"

#include "multisphere/multisphere_spacing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace ellipsoid {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("multisphere template: " + what);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

void check_semiaxes(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b) || !(b > 0.0) || !(a > b))
    refuse("semi-axes a = " + number(a) + ", b = " + number(b) +
           "; finite values with a > b > 0 are needed: give the long semi-axis first");
  if (!(a / b >= smallest_aspect_ratio && a / b <= largest_aspect_ratio))
    refuse("aspect ratio a/b = 1 + " + number(a / b - 1.0) + "; it may be from 1 + 1e-06 to " +
           number(largest_aspect_ratio) + ": change a or b, or use a sphere");
}

void check_is_chain(SphereSpacing spacing) {
  if (is_planar(spacing))
    refuse("spacing " + word_of(spacing) +
           " is a set of spheres in a plane, no chain; a chain needs another spacing: use one of " +
           words_of_chains());
}

void check_count(int count) {
  if (count >= 1 && count <= largest_sphere_count && count % 2 == 1)
    return;
  const bool between_odd = count >= 2 && count < largest_sphere_count;
  refuse("number of sub-spheres N = " + std::to_string(count) + "; an odd number from 1 to " +
         std::to_string(largest_sphere_count) + " is needed" +
         (between_odd ? ": use " + std::to_string(count - 1) + " or " + std::to_string(count + 1)
                      : std::string(": choose one in this range")));
}

/// Markauskas et al. 2010, section 4.2.1.
HalfChain touching_half_chain(double a, double b) {
  return {{0.0, 0.5 * (a + b)}, {b, 0.5 * (a - b)}};
}

/// Of spacing `paper_touching`; besides it there is N = 1, a single sphere.
constexpr int largest_touching_count = 3;

bool is_known(int count, SphereSpacing spacing) {
  return spacing != SphereSpacing::paper_touching || count <= largest_touching_count;
}

HalfChain half_chain(double a, double b, int n, SphereSpacing spacing) {
  if (n == 0)
    return {{0.0}, {b}};
  switch (spacing) {
  case SphereSpacing::minimax_outline:
    return minimax_outline_half_chain(a, b, n);
  case SphereSpacing::minimax_area:
    return minimax_area_half_chain(a, b, n);
  case SphereSpacing::paper_touching:
    return touching_half_chain(a, b);
  case SphereSpacing::medial:
  case SphereSpacing::minimax_volume:
  case SphereSpacing::paper:
    break;
  }
  const HalfChain half = paper_half_chain(a, b, n);
  return n == 1 && !neighbours_overlap(half) ? touching_half_chain(a, b) : half;
}

/// Condition after eq. (6). N = 3 of section 4.2.1 touches; beyond a = 3b its side spheres would be
/// larger than the centre sphere.
bool is_admissible(const HalfChain& half, SphereSpacing spacing) {
  const bool may_touch =
      spacing == SphereSpacing::paper || spacing == SphereSpacing::paper_touching;
  if (half.centres.size() == 2 && may_touch)
    return half.radii[1] <= half.radii[0];
  return neighbours_overlap(half);
}

} // namespace

int smallest_overlapping_count(double aspect_ratio, SphereSpacing spacing) {
  check_semiaxes(aspect_ratio, 1.0);
  check_is_chain(spacing);
  if (spacing == SphereSpacing::paper_touching)
    return 0;
  const auto overlaps = [&](int n) {
    return neighbours_overlap(half_chain(aspect_ratio, 1.0, n, spacing));
  };
  // More spheres lie closer together: the first n that works is found by doubling and bisection.
  const int largest = (largest_sphere_count - 1) / 2;
  int low = 1, high = low;
  while (!overlaps(high)) {
    if (high == largest)
      return 0;
    low = high;
    high = std::min(2 * high, largest);
  }
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (overlaps(middle) ? high : low) = middle;
  }
  return 2 * high + 1;
}

MultisphereTemplate make_multisphere(double a, double b, int count, SphereSpacing spacing) {
  check_semiaxes(a, b);
  check_count(count);
  check_is_chain(spacing);
  if (!is_known(count, spacing))
    refuse("spacing paper_touching with N = " + std::to_string(count) +
           "; it is for N = 1 and 3 only: use spacing paper");
  // Solved for b = 1, then scaled: the result does not depend on the unit of length.
  HalfChain half = half_chain(a / b, 1.0, (count - 1) / 2, spacing);
  if (!is_admissible(half, spacing)) {
    const int smallest = smallest_overlapping_count(a / b, spacing);
    refuse("with N = " + std::to_string(count) + " sub-spheres at aspect ratio " + number(a / b) +
           (count == 3 && half.radii[1] > half.radii[0]
                ? " the side spheres are larger than the centre sphere"
                : " neighbouring sub-spheres do not overlap") +
           (smallest > 0 ? "; the smallest N whose spheres overlap with this spacing is " +
                               std::to_string(smallest)
                         : "; no N up to " + std::to_string(largest_sphere_count) +
                               " works: lower the aspect ratio or use spacing minimax"));
  }
  for (double& x : half.centres)
    x *= b;
  for (double& r : half.radii)
    r *= b;
  return mirrored(a, b, spacing, half);
}

const char* word_of(ShapeMeasure what) {
  switch (what) {
  case ShapeMeasure::area:
    return "area";
  case ShapeMeasure::volume:
    return "volume";
  case ShapeMeasure::perimeter:
    return "perimeter";
  case ShapeMeasure::outline:
    break;
  }
  return "outline";
}

double relative_error(const MultisphereMeasures& measures, const MultisphereTemplate& chain,
                      ShapeMeasure what) {
  switch (what) {
  case ShapeMeasure::area:
    return measures.area_between / ellipse_area(chain.a, chain.b);
  case ShapeMeasure::volume:
    return measures.volume_between / ellipsoid_volume(chain.a, chain.b);
  case ShapeMeasure::perimeter:
    return measures.perimeter_shape_factor;
  case ShapeMeasure::outline:
    break;
  }
  return measures.outline_deviation / chain.b;
}

int sphere_count_for(double aspect_ratio, ShapeMeasure what, double tolerance,
                     SphereSpacing spacing) {
  check_semiaxes(aspect_ratio, 1.0);
  check_is_chain(spacing);
  if (!std::isfinite(tolerance) || !(tolerance > 0.0))
    refuse("tolerance " + number(tolerance) + "; a positive number is needed, such as 0.01");
  for (int n = 0; 2 * n + 1 <= largest_sphere_count && is_known(2 * n + 1, spacing); ++n) {
    const HalfChain half = half_chain(aspect_ratio, 1.0, n, spacing);
    if (!is_admissible(half, spacing))
      continue;
    const MultisphereTemplate chain = mirrored(aspect_ratio, 1.0, spacing, half);
    if (relative_error(measure(chain), chain, what) <= tolerance)
      return 2 * n + 1;
  }
  refuse("no N up to " + std::to_string(largest_sphere_count) + " keeps the " + word_of(what) +
         " within " + number(tolerance) + " at aspect ratio " + number(aspect_ratio) +
         ": allow a larger tolerance");
}

std::vector<SpacingComparison> compare_spacings(const std::vector<double>& aspect_ratios,
                                                double tolerance) {
  std::vector<SpacingComparison> rows;
  for (const double s : aspect_ratios)
    for (const ShapeMeasure what :
         {ShapeMeasure::area, ShapeMeasure::volume, ShapeMeasure::outline})
      rows.push_back({s, what, sphere_count_for(s, what, tolerance, SphereSpacing::paper),
                      sphere_count_for(s, what, tolerance, SphereSpacing::minimax_outline),
                      sphere_count_for(s, what, tolerance, SphereSpacing::minimax_area)});
  return rows;
}

} // namespace ellipsoid
