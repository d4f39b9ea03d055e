// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Base class of a granular wall with LIGGGHTS-PFM. The host reads the command without the names of
// the models, and so makes none.
#pragma once

#include "error.h"
#include "fix_property_atom.h"
#include "fix_wall_gran.h"
#include "host_contact.h"
#include "own_models.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ellipsoid_host {

/// A wall command, taken apart.
struct WallWords {
  static constexpr int first_name = 3; // behind ID, group and style
  std::int64_t models;                 ///< see OwnModels::select(); -1: one is unknown
  std::vector<char*> others;           ///< the command without the names of the models

  WallWords(int narg, char** arg) : others(arg, arg + first_name) {
    int count = narg - first_name;
    char** words = arg + first_name;
    models = OwnModels::select(count, words);
    others.insert(others.end(), words, words + count);
  }
};

class HostWall : public LAMMPS_NS::FixWallGran {
 public:
  int64_t hashcode() override { return models_.hashcode(); }

 protected:
  HostWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
      : HostWall(lmp, narg, arg, WallWords(narg, arg)) {}

  OwnModels& models() { return models_; }
  LAMMPS_NS::PrimitiveWall& primitive_wall() { return *primitiveWalls_[0]; }
  /// The values that the wall keeps of each particle's contacts; the host deletes the fix with the
  /// wall.
  void set_history(LAMMPS_NS::FixPropertyAtom* fix) { primitiveWallsHistory_ = {fix}; }
  double* history_values(int particle) { return primitiveWallsHistory_[0]->array_atom[particle]; }
  bool stores_of_contacts() const { return store_force_contact_; }

  /// Is not called: whatever does not run in batches is refused before.
  void apply_models(LCM::SurfacesIntersectData& data, double*, LAMMPS_NS::FixMeshSurface*, int,
                    int) {
    LCM::ForceData unused;
    models_.apply(data, unused, unused);
  }

  void check_heat() {}
  void begin_heat() {}
  double sphere_of_heat(int, double) const { return 0.0; }
  double depth_of_heat(int, double) const { return 0.0; }

 private:
  OwnModels models_;

  HostWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, WallWords words)
      : FixWallGran(lmp, static_cast<int>(words.others.size()), words.others.data()),
        models_(lmp, this, words.models) {
    if (words.models == -1)
      error->fix_error(FLERR, this,
                       (std::string("unknown contact model; allowed are ") +
                        OwnModels::known_names + ", in this order; correct the names")
                           .c_str());
    iarg_ += narg - static_cast<int>(words.others.size()); // of the whole command
    const std::string problem = models_.read_settings(narg - iarg_, arg + iarg_, this);
    if (!problem.empty())
      error->fix_error(FLERR, this, problem.c_str());
  }
};

} // namespace ellipsoid_host
