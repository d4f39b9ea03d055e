// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "flow_through.h"

#include <map>
#include <optional>
#include <vector>

namespace ellipsoid::post {

/// How long particles were in a system before they left it through a gate.
class ResidenceTimes {
 public:
  void enter(std::int64_t id, double time) { entered_[id] = time; }
  /// The time since a particle entered, for one that leaves; none where that was not seen. It must
  /// enter again to be counted again.
  std::optional<double> leave(std::int64_t id, double time);

  const std::vector<double>& times() const { return times_; } ///< of all that left
  std::size_t unknown() const { return unknown_; }            ///< left, not seen to enter

 private:
  std::map<std::int64_t, double> entered_;
  std::vector<double> times_;
  std::size_t unknown_ = 0;
};

} // namespace ellipsoid::post
