// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "picture_options.h"

#include "frame_loop.h"
#include "option_checks.h"
#include "run_log.h"

#include <fmt/format.h>

namespace ellipsoid::post {

std::string PictureNames::next(const ChosenFrame& chosen) {
  std::string name = pattern_;
  if (const auto star = name.find('*'); star != std::string::npos)
    name.replace(star, 1, fmt::format("{:010d}", chosen.frame.timestep));
  if (!given_.insert(name).second)
    throw InputError(
        fmt::format("the picture {} is there already, of another frame or run: take one "
                    "run at a time, with an asterisk in the name for the time step",
                    name));
  return name;
}

std::string film_name_problem(const FrameOptions& frames, const std::string& name) {
  return frames.frames == "all" && !name.empty() && name.find('*') == std::string::npos
             ? fmt::format(
                   "--frame all makes a picture of each frame: give '{}' an asterisk, which "
                   "becomes the time step",
                   name)
             : "";
}

namespace {

/// Time of a frame (s): of the file, or of its step and the log beside it.
std::optional<double> time_of(const ChosenFrame& chosen) {
  if (chosen.frame.time)
    return chosen.frame.time;
  const RunLog* log = run_log_of(chosen.frame.location.file);
  if (!log || !log->time_step)
    return std::nullopt;
  return *log->time_step * static_cast<double>(chosen.frame.timestep);
}

} // namespace

std::string frame_title(const ChosenFrame& chosen) {
  const std::optional<double> time = time_of(chosen);
  return fmt::format("{} particles, {}", chosen.set.particles.size(),
                     time ? fmt::format("t = {:.4g} s", *time)
                          : fmt::format("time step {}", chosen.frame.timestep));
}

CLI::Validator picture_name_check() {
  return check_by([](const std::string& name) { picture_format(name); });
}

void write_pile_picture(const std::string& name, const ChosenFrame& chosen, const Pile& pile,
                        const PileOptions& pile_options, const std::vector<ReposeAngle>& flanks,
                        const PilePictureOptions& options) {
  PilePictureOptions titled = options;
  if (titled.title.empty())
    titled.title = frame_title(chosen);
  write_text(name, draw_pile(picture_format(name), chosen.frame, chosen.set, pile, pile_options,
                             flanks, titled));
  fmt::print(stderr, "picture: {}\n", name);
}

} // namespace ellipsoid::post
