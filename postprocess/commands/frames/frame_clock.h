// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"
#include "frame_steps.h"
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

/// Warns of a run whose frames may be too far apart.
inline void warn_of_long_steps(const std::string& run, const LongSteps& steps) {
  if (steps.doubtful > 0)
    report_warning(run + ": " + std::to_string(steps.doubtful) +
                       " steps of particles between frames are longer than 0.4 of an edge that "
                       "repeats: if one was longer than half, its way is not known",
                   "long steps of " + run);
  if (steps.by_flags > 0)
    report_warning(run + ": " + std::to_string(steps.by_flags) +
                       " steps of particles between frames are longer than half of an edge that "
                       "repeats, by image flags or unwrapped positions: these do not tell ways of "
                       "spheres of the host's rigid bodies (dump id_multisphere with them)",
                   "steps by flags of " + run);
}

} // namespace ellipsoid::post
