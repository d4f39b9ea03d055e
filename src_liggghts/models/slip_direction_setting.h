// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "law/tangential_laws.h"
#include "settings.h"

#include <string>

namespace LIGGGHTS {
namespace ContactModels {

/// Keyword `direction displacement|velocity` of `tangential history/viscous`.
class SlipDirectionSetting : public EnumSetting<ellipsoid::SlipDirection> {
 public:
  SlipDirectionSetting(std::string name, ellipsoid::SlipDirection)
      : EnumSetting<ellipsoid::SlipDirection>(name) {
    addOption("displacement", ellipsoid::SlipDirection::displacement);
    addOption("velocity", ellipsoid::SlipDirection::velocity);
    setDefault("displacement");
  }

  int parseArguments(char** args) override {
    const int consumed = EnumSetting<ellipsoid::SlipDirection>::parseArguments(args);
    if (consumed < 0)
      error_message = std::string("keyword 'direction' has the value '") + args[1] +
                      "', allowed is one of 'displacement', 'velocity'";
    return consumed;
  }
};

} // namespace ContactModels
} // namespace LIGGGHTS
