// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Settings of the surface models of ellipsoids. The models let the host parse them, which checks
// their values; pair style and walls read from the command, by in(), what they themselves need.
#pragma once

#include "model_settings.h"
#include "multisphere/multisphere_contact.h"
#include "settings.h"
#include "whole_number.h"

#include <limits>
#include <string>

namespace LIGGGHTS {
namespace ContactModels {

/// Keyword `contacts K`: simultaneous contacts of one pair of particles (or of a particle and a
/// wall) that each has room for; the histories of more are kept elsewhere.
class ContactsSetting : public Setting {
 public:
  typedef int value_type;
  static constexpr int standard = 8;
  /// Slots are numbered by short integers.
  static constexpr int largest = std::numeric_limits<short>::max();
  /// The number in a command that the models have accepted.
  static int in(const ellipsoid_host::ModelSettings& settings) {
    return settings.number("contacts", standard);
  }

  ContactsSetting(std::string name, int value) : Setting(name, 1) { current_.setValue(value); }

  void registerTarget(int& target) { current_.registerTarget(target); }

  int parseArguments(char** args) override {
    if (name != args[0])
      return 0;
    const std::optional<long> value = ellipsoid_host::whole_integer(args[1]);
    if (value && *value >= 1 && *value <= largest) {
      current_.setValue(static_cast<int>(*value));
      return 2;
    }
    error_message = "keyword '" + name + "' has the value '" + args[1] +
                    "', allowed is an integer from 1 to " + std::to_string(largest);
    return -1;
  }

  void print_value(FILE* out) override { fprintf(out, "%d", current_.getValue()); }

 private:
  ValuePropagator<int> current_;
};

/// Keyword `multicontact sum|average`.
class MulticontactSetting : public EnumSetting<ellipsoid::MulticontactRule> {
 public:
  /// The rule in a command that the models have accepted.
  static ellipsoid::MulticontactRule in(const ellipsoid_host::ModelSettings& settings) {
    return settings.value("multicontact", "sum") == "average" ? ellipsoid::MulticontactRule::average
                                                              : ellipsoid::MulticontactRule::sum;
  }

  MulticontactSetting(std::string name, ellipsoid::MulticontactRule)
      : EnumSetting<ellipsoid::MulticontactRule>(name) {
    addOption("sum", ellipsoid::MulticontactRule::sum);
    addOption("average", ellipsoid::MulticontactRule::average);
    setDefault("sum");
  }
};

} // namespace ContactModels
} // namespace LIGGGHTS
