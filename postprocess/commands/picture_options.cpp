// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "picture_options.h"

#include "frame_loop.h"
#include "option_checks.h"

#include <fmt/format.h>

namespace ellipsoid::post {

std::string name_with_step(const std::string& path, std::int64_t step) {
  std::string name = path;
  if (const auto star = name.find('*'); star != std::string::npos)
    name.replace(star, 1, fmt::format("{:010d}", step));
  return name;
}

std::string frame_title(const ChosenFrame& chosen) {
  return fmt::format("{} particles, time step {}", chosen.set.particles.size(),
                     chosen.frame.timestep);
}

CLI::Validator picture_name_check() {
  return check_by([](const std::string& name) { picture_format(name); });
}

void write_pile_picture(const std::string& path, const ChosenFrame& chosen, const Pile& pile,
                        const PileOptions& pile_options, const std::vector<ReposeAngle>& flanks,
                        const PilePictureOptions& options) {
  const std::string name = name_with_step(path, chosen.frame.timestep);
  PilePictureOptions titled = options;
  if (titled.title.empty())
    titled.title = frame_title(chosen);
  write_text(name, draw_pile(picture_format(name), chosen.frame, chosen.set, pile, pile_options,
                             flanks, titled));
  fmt::print(stderr, "picture: {}\n", name);
}

} // namespace ellipsoid::post
