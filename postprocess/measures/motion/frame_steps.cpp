// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_steps.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {

void FrameSteps::advance(const ParticleSet& set, const PeriodicCell& cell) {
  before_ = now_;
  knew_ways_ = knows_ways_;
  now_ = cell;
  knows_ways_ = bool(set.tells_ways);
}

Vector3 FrameSteps::way(const Vector3& before, const Vector3& now) const {
  if (!knew_ways_ || !knows_ways_)
    return now_.nearest(now - before);
  const Vector3 f = before_.fractions(before);
  const double shares[] = {f.x, f.y, f.z};
  Vector3 way = now - before;
  for (std::size_t k = 0; k < 3; ++k)
    if (now_.is_periodic(k)) // an image outside of the box goes along with edges that change
      way -= std::floor(shares[k]) * now_.nearest(now_.edge(k) - before_.edge(k));
  return way;
}

void FrameSteps::count_long(const Vector3& way, LongSteps& steps) const {
  constexpr double nearly_half = 0.4, half = 0.5;
  const double share = largest_share(way);
  if (knew_ways_ && knows_ways_)
    steps.by_flags += share > half ? 1 : 0;
  else
    steps.doubtful += share > nearly_half ? 1 : 0;
}

double FrameSteps::largest_share(const Vector3& way) const {
  const Vector3 f = now_.fractions(now_.corner() + way);
  const double shares[] = {f.x, f.y, f.z};
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    if (now_.is_periodic(k))
      largest = std::max(largest, std::abs(shares[k]));
  return largest;
}

} // namespace ellipsoid::post
