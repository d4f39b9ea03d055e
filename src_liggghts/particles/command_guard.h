// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Guards each command of an input script before and after the host executes it: refuses what is
// unsuited for ellipsoids, and completes what the host's commands leave undone on them.
#pragma once

#include "new_numbers.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

/// Lives as long as the host executes the command. Does nothing without atom_style
/// granular/ellipsoid.
class CommandGuard {
 public:
  /// Stops with one line where the command does not work with ellipsoids.
  CommandGuard(LAMMPS_NS::LAMMPS* lmp, const char* command, int count, char** arguments);
  /// Completes `set`, `velocity` and `displace_atoms`: omega and angular momentum agree, bodies
  /// turn with their centres, moments follow the mass; contact histories know the new numbers that
  /// `delete_atoms` gives.
  ~CommandGuard();
  CommandGuard(const CommandGuard&) = delete;
  CommandGuard& operator=(const CommandGuard&) = delete;

 private:
  LAMMPS_NS::LAMMPS* lmp_;
  std::string command_;
  std::vector<std::string> arguments_;
  std::vector<double> masses_; // before `set ... mass`, of the particles of this rank

  std::unique_ptr<Renumbering> renumbering_; // while the host deletes particles

  bool has_argument(const std::string& word) const;
  bool goes_on_without_set_up() const;
  void begin_deletion();
  void complete_set();
  void turn_bodies() const;
};

} // namespace ellipsoid_host
