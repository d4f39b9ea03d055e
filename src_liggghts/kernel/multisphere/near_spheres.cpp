// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/near_spheres.h"

#include <algorithm>

namespace ellipsoid {
namespace {

double abscissa(const MultispherePose& pose, int k) {
  return pose.body->is_chain() ? pose.body->abscissa(k) : 0.0;
}

} // namespace

void NearSpheres::restart(std::size_t pairs) {
  of_pairs_.assign(pairs, OfPair());
  spheres_.assign(1, SpherePair()); // where pairs without any begin
}

NearSpheres::Search NearSpheres::search(std::size_t pair, const MultispherePose& i,
                                        const MultispherePose& j, const Vector3& centre_distance,
                                        double gap) {
  OfPair& of_pair = of_pairs_[pair];
  of_pair.count = 0;
  of_pair.until = {0.0, 0.0};
  const double bound = smallest_gap(i, j, centre_distance);
  if (bound > gap)
    return {usable_share * bound, 0};
  double nearest = gap;
  int tested = find(i, j, centre_distance, gap);
  if (found_.empty())
    nearest = nearest_gap(i, j, centre_distance, second_reach * gap, tested);
  keep_found(pair);
  return {usable_share * nearest, tested};
}

/// @return how many distances between spheres were computed
int NearSpheres::find(const MultispherePose& i, const MultispherePose& j,
                      const Vector3& centre_distance, double gap) {
  found_.clear();
  return for_each_near_pair(i, j, centre_distance, gap, [&](int k, int l, double overlap) {
    if (overlap > -gap)
      found_.push_back({abscissa(i, k), abscissa(j, l), i.body->radius(k), j.body->radius(l),
                        static_cast<short>(k), static_cast<short>(l), -1});
  });
}

/// A pair whose room is too small gets a new one of double size at the end.
void NearSpheres::keep_found(std::size_t pair) {
  OfPair& of_pair = of_pairs_[pair];
  std::sort(found_.begin(), found_.end(), [](const SpherePair& a, const SpherePair& b) {
    return a.sphere_i != b.sphere_i ? a.sphere_i < b.sphere_i : a.sphere_j < b.sphere_j;
  });
  of_pair.count = static_cast<int>(found_.size());
  if (of_pair.count > of_pair.room) {
    of_pair.first = static_cast<unsigned>(spheres_.size());
    of_pair.room = 2 * of_pair.count;
    spheres_.resize(spheres_.size() + static_cast<std::size_t>(of_pair.room));
  }
  std::copy(found_.begin(), found_.end(), begin(pair));
}

} // namespace ellipsoid
