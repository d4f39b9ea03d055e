// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "residence_times.h"

namespace ellipsoid::post {

std::optional<double> ResidenceTimes::leave(std::int64_t id, double time) {
  const auto entered = m_entered.find(id);
  if (entered == m_entered.end()) {
    ++m_unknown;
    return {};
  }
  m_times.push_back(time - entered->second);
  m_entered.erase(entered);
  return m_times.back();
}

} // namespace ellipsoid::post
