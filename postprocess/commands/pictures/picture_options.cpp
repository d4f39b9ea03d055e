// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "picture_options.h"

#include "contacts.h"
#include "frame_loop.h"
#include "messages.h"
#include "option_checks.h"
#include "run_state.h"

#include <algorithm>
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

int checked_code(int code, const PictureNames& names) {
  if (code != exit_good || names.has_given())
    return code;
  report_error("there is no picture: no frame holds particles");
  return exit_bad_data;
}

void warn_of_empty_view(const std::string& run, const ParticleSet& set, const Box& view,
                        std::size_t axes) {
  const auto is_seen = [&](const Particle& p) {
    const double centre[] = {p.centre.x, p.centre.y, p.centre.z}, reach = bounding_radius(set, p);
    for (std::size_t k = 0; k < axes; ++k)
      if (centre[k] + reach < view.lower[k] || centre[k] - reach > view.upper[k])
        return false;
    return true;
  };
  if (std::none_of(set.particles.begin(), set.particles.end(), is_seen))
    report_warning(run + ": no particle lies in --view", "view of " + run);
}

std::optional<double> seconds_of(const ChosenFrame& chosen) {
  if (chosen.frame.time)
    return chosen.frame.time;
  const RunLog* log = log_of(chosen);
  if (!log || !log->time_step)
    return std::nullopt;
  return *log->time_step * static_cast<double>(chosen.frame.timestep);
}

std::string frame_title(const ChosenFrame& chosen) {
  const std::optional<double> time = seconds_of(chosen);
  return fmt::format("{} particles, {}", chosen.set.particles.size(),
                     time ? fmt::format("t = {:.4g} s", *time)
                          : fmt::format("time step {}", chosen.frame.timestep));
}

CLI::Validator picture_name_check() {
  return check_by([](const std::string& name) { picture_format(name); });
}

void add_colour_options(CLI::App& command, std::string& colour_by, std::vector<double>& range) {
  command.add_option("--colour,--color", colour_by,
                     "colour by a column of the file, or by angle (of the long axis) or speed");
  command.add_option("--colour-range", range, "lower and upper end of the colour scale")
      ->expected(2);
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
