// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/multisphere_watch.h"

#include <algorithm>

namespace ellipsoid {

void ContactWatch::restart(std::size_t pairs) {
  watched_.assign(pairs, Watched());
  spheres_.assign(1, SpherePair()); // the first place of pairs that have none
}

ContactWatch::Search ContactWatch::search(std::size_t pair, const ChainPose& i, const ChainPose& j,
                                          const Vector3& centre_distance, double gap) {
  Watched& watched = watched_[pair];
  watched.count = 0;
  watched.until = {0.0, 0.0};
  const double bound = smallest_gap(i, j, centre_distance);
  if (bound > gap)
    return {usable_share * bound, 0};
  double nearest = gap;
  int tested = find(i, j, centre_distance, gap);
  if (found_.empty()) {
    nearest = second_reach * gap;
    tested += for_each_near_pair(
        i, j, centre_distance, second_reach * gap,
        [&](int, int, double overlap) { nearest = std::fmin(nearest, -overlap); });
  }
  keep_found(pair);
  return {usable_share * nearest, tested};
}

/// @return how many distances between spheres were computed
int ContactWatch::find(const ChainPose& i, const ChainPose& j, const Vector3& centre_distance,
                       double gap) {
  found_.clear();
  return for_each_near_pair(i, j, centre_distance, gap, [&](int k, int l, double overlap) {
    if (overlap > -gap)
      found_.push_back({i.chain->centre(k), j.chain->centre(l), i.chain->radius(k),
                        j.chain->radius(l), static_cast<short>(k), static_cast<short>(l), -1});
  });
}

/// A pair whose room is too small gets a new one of double size at the end.
void ContactWatch::keep_found(std::size_t pair) {
  Watched& watched = watched_[pair];
  std::sort(found_.begin(), found_.end(), [](const SpherePair& a, const SpherePair& b) {
    return a.sphere_i != b.sphere_i ? a.sphere_i < b.sphere_i : a.sphere_j < b.sphere_j;
  });
  watched.count = static_cast<int>(found_.size());
  if (watched.count > watched.room) {
    watched.first = static_cast<unsigned>(spheres_.size());
    watched.room = 2 * watched.count;
    spheres_.resize(spheres_.size() + static_cast<std::size_t>(watched.room));
  }
  std::copy(found_.begin(), found_.end(), begin(pair));
}

} // namespace ellipsoid
