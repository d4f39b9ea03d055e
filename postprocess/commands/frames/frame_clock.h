// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"
#include "input_error.h"
#include "messages.h"

#include <cstdint>
#include <optional>
#include <string>

namespace ellipsoid::post {

/// The order of a run's frames, for measures of what happens between them.
class FrameClock {
 public:
  /// Whether a frame comes later than the one before it; a frame that is repeated does not.
  /// Throws InputError for one that comes earlier.
  bool advances(const ChosenFrame& chosen) {
    const std::int64_t step = chosen.frame.timestep;
    if (last_ && step < *last_)
      throw InputError("this frame comes before the one ahead of it in the files: name the files "
                       "in the order of time");
    const bool is_later = !last_ || step > *last_;
    last_ = step;
    return is_later;
  }

 private:
  std::optional<std::int64_t> last_; ///< time step
};

/// Warns of a run whose frames may be too far apart. @param[in] count of long steps
inline void warn_of_long_steps(const std::string& run, std::size_t count) {
  if (count > 0)
    report_warning(run + ": " + std::to_string(count) +
                       " steps of particles between frames are longer than 0.4 of an edge that "
                       "repeats: if one was longer than half, its way is not known",
                   "long steps of " + run);
}

} // namespace ellipsoid::post
