// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid_counts.h"

#include "multisphere/ellipsoid_spheres.h"
#include "sphere_set_measures.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>
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

int count_within(const Vector3& semiaxes, SphereSpacing spacing, SetError what, double tolerance) {
  const Errors errors(semiaxes, spacing, what);
  const int most = largest_count_of(spacing);
  const auto odd = [](int n) { return n + (n + 1) % 2; };
  int low = 0, high = 1;
  while (!errors.are_within(tolerance, high, quick_columns)) {
    if (high == most)
      throw std::invalid_argument(fmt::format(
          "multisphere template: no N up to {} with spacing {} comes within {:g} at semi-axes {:g} "
          "{:g} {:g}: allow a larger tolerance",
          most, word_of(spacing), tolerance, semiaxes.x, semiaxes.y, semiaxes.z));
    low = high;
    high = std::min(odd(2 * high), most);
  }
  while (high - low > 2) {
    const int middle = odd((low + high) / 2);
    if (middle >= high)
      break;
    (errors.are_within(tolerance, middle, quick_columns) ? high : low) = middle;
  }
  while (high < most && !errors.are_within(tolerance, high, comparison_columns))
    high += 2;
  return high;
}

} // namespace ellipsoid::post
