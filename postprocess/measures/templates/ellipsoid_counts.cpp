// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid_counts.h"

#include "multisphere/ellipsoid_spheres.h"
#include "sphere_set_measures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ellipsoid::post {
namespace {

constexpr int quick_columns = 120; ///< of the search

/// The error of a set, infinite where the spheres are not one body.
class Errors {
 public:
  Errors(const Vector3& semiaxes, SphereSpacing spacing, SetError what)
      : semiaxes_(semiaxes), spacing_(spacing), what_(what), solid_(solid_ellipsoid(semiaxes)) {}

  double of(int count, int along) const {
    const SphereSet set = place_ellipsoid_spheres(semiaxes_, count, spacing_);
    if (!is_one_body(set))
      return std::numeric_limits<double>::infinity();
    if (what_ == SetError::volume)
      return share_in_exactly_one(set, solid_, along);
    const OutlineDistances found = outline_distances(set, solid_);
    return std::max(found.largest_to_solid, found.largest_to_spheres) /
           std::min({semiaxes_.x, semiaxes_.y, semiaxes_.z});
  }
  bool are_within(double tolerance, int count, int along) const {
    return of(count, along) <= tolerance;
  }

 private:
  Vector3 semiaxes_;
  SphereSpacing spacing_;
  SetError what_;
  Solid solid_;
};

} // namespace

double error_of(const Vector3& semiaxes, int count, SphereSpacing spacing, SetError what) {
  return Errors(semiaxes, spacing, what).of(count, comparison_columns);
}

namespace {

/// Numbers of spheres with their errors.
struct Counted {
  int count = 0;
  double error = std::numeric_limits<double>::infinity();
};

/// Where a power law through two of them meets the tolerance; not a number where there is none.
double meeting_point(const Counted& few, const Counted& more, double tolerance) {
  const double order = std::log(few.error / more.error) / std::log(1.0 * more.count / few.count);
  return more.count * std::pow(more.error / tolerance, 1.0 / order);
}

int odd(double n) {
  const int whole = static_cast<int>(n);
  return whole + (whole + 1) % 2;
}

/// The first number tried that is within the tolerance, behind one that is not.
std::pair<Counted, Counted> bracket(const Errors& errors, double tolerance, int most) {
  Counted low, high{1, errors.of(1, quick_columns)};
  while (!(high.error <= tolerance)) {
    if (high.count == most)
      return {high, {}};
    double next = 2.0 * high.count;
    if (low.count > 0 && std::isfinite(low.error))
      if (const double meeting = meeting_point(low, high, tolerance); std::isfinite(meeting))
        next = std::clamp(1.05 * meeting, 1.3 * high.count, 6.0 * high.count);
    low = high;
    high.count = std::min(odd(std::max(next, high.count + 2.0)), most);
    high.error = errors.of(high.count, quick_columns);
  }
  return {low, high};
}

} // namespace

int count_within(const Vector3& semiaxes, SphereSpacing spacing, SetError what, double tolerance) {
  const Errors errors(semiaxes, spacing, what);
  const int most = largest_count_of(spacing);
  auto [low, high] = bracket(errors, tolerance, most);
  if (high.count == 0)
    throw std::invalid_argument(fmt::format(
        "multisphere template: no N up to {} with spacing {} comes within {:g} at semi-axes {:g} "
        "{:g} {:g}: allow a larger tolerance",
        most, word_of(spacing), tolerance, semiaxes.x, semiaxes.y, semiaxes.z));
  while (high.count - low.count > 2) {
    double next = 0.5 * (low.count + high.count);
    if (low.count > 0 && std::isfinite(low.error))
      if (const double meeting = meeting_point(low, high, tolerance); std::isfinite(meeting))
        next = std::clamp(meeting, 0.9 * low.count + 0.1 * high.count,
                          0.1 * low.count + 0.9 * high.count);
    Counted middle{std::clamp(odd(next), low.count + 1 + low.count % 2, high.count - 2)};
    middle.error = errors.of(middle.count, quick_columns);
    (middle.error <= tolerance ? high : low) = middle;
  }
  while (high.count < most && !errors.are_within(tolerance, high.count, comparison_columns))
    high.count += 2;
  return high.count;
}

} // namespace ellipsoid::post
