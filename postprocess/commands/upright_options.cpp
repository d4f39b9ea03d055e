// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "upright_options.h"

namespace ellipsoid::post {

void add_up_option(CLI::App& command, std::string& up) {
  command
      .add_option("--up", up,
                  "axis that points up: y or z (with y, the plan's x is the file's z "
                  "and its y the file's x)")
      ->check(CLI::IsMember({"y", "z"}))
      ->capture_default_str();
}

ParticleSet upright(const ParticleSet& set, const std::string& up) {
  return turned_upright(set, up == "y" ? UpAxis::y : UpAxis::z);
}

} // namespace ellipsoid::post
