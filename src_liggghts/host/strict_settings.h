// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Settings of contact models that are checked as strictly as the arguments of our fixes.
#ifndef ELLIPSOID_STRICT_SETTINGS_H
#define ELLIPSOID_STRICT_SETTINGS_H

#include "settings.h"
#include "whole_number.h"

#include <limits>
#include <string>

namespace LIGGGHTS {
namespace ContactModels {

/// Keyword `contacts K`: simultaneous contacts of one pair of particles (or of a particle and a
/// wall) that have a place in the history.
class ContactsSetting : public Setting {
 public:
  typedef int value_type;
  static constexpr int standard = 8;
  /// Slots are numbered by short integers.
  static constexpr int largest = std::numeric_limits<short>::max();
  /// What to do where there are `found` contacts and no room for all.
  static std::string remedy(int found) {
    return found <= largest ? "give 'contacts " + std::to_string(found) + "' or more"
                            : "use fewer sub-spheres: no more than " + std::to_string(largest) +
                                  " contacts of one pair can be kept";
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

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
