// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "step_names.h"

#include "input_error.h"

#include <fmt/format.h>
#include <mutex>
#include <set>

namespace ellipsoid::post {

std::string name_with_step(const std::string& pattern, std::int64_t timestep) {
  static std::mutex mutex;
  static std::set<std::string> given;
  std::string name = pattern;
  if (const auto star = name.find('*'); star != std::string::npos)
    name.replace(star, 1, fmt::format("{:010d}", timestep));
  const std::lock_guard<std::mutex> lock(mutex);
  if (!given.insert(name).second)
    throw InputError(name + " would be written for several frames: put an asterisk into the name, "
                            "which becomes the time step");
  return name;
}

} // namespace ellipsoid::post
