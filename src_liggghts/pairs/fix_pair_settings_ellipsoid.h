// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix pair_settings/ellipsoid: made by pair_style gran/ellipsoid. It keeps the arguments of that
// command, the IDs and laws of the walls and the sub-spheres of the templates in restart files, and
// compares them with those of the run that goes on from such a file.
#ifdef FIX_CLASS
// clang-format off
FixStyle(pair_settings/ellipsoid,FixPairSettingsEllipsoid)
// clang-format on
#else
#ifndef LMP_FIX_PAIR_SETTINGS_ELLIPSOID_H
#define LMP_FIX_PAIR_SETTINGS_ELLIPSOID_H

#include "fix.h"
#include "host_variants.h"

#include <string>

namespace ellipsoid_host {

class HasLaw;

/// Where a wall is defined after read_restart: stops if the file has contacts with a wall of this
/// ID by another law, or of another kind. Meshes may be added behind those of the file.
void compare_with_restart(LAMMPS_NS::LAMMPS* lmp, const std::string& id, const HasLaw& wall);

} // namespace ellipsoid_host

namespace LAMMPS_NS {

class FixPairSettingsEllipsoid : public Fix {
 public:
  FixPairSettingsEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  int setmask() override { return 0; }
  void write_restart(FILE* file) override;
  /// Stops if the pair style differs; warns of walls that are gone and of templates that differ.
  void restart(ELLIPSOID_RESTART_PARAMETERS) override;

 private:
  std::string present_arguments() const;
  void compare_arguments(const std::string& former) const;
  void look_for_wall(const std::string& id) const;
  void compare_template(const std::string& id, const std::string& former) const;
};

} // namespace LAMMPS_NS

#endif
#endif
