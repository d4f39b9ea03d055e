// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "residence_times.h"

namespace ellipsoid::post {

std::optional<double> ResidenceTimes::leave(std::int64_t id, double time) {
  const auto entered = entered_.find(id);
  if (entered == entered_.end()) {
    ++unknown_;
    return {};
  }
  times_.push_back(time - entered->second);
  entered_.erase(entered);
  return times_.back();
}

} // namespace ellipsoid::post
