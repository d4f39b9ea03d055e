// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace LIGGGHTS {
namespace ContactModels {

/// Says on the screen and in the log how the forces of contacts are computed: before the first run,
/// and whenever that has changed. Stops where the host's contact models would have to be called,
/// and cannot be.
class BatchNotice {
 public:
  /// @param[in] who      pair style or wall, as messages name it
  /// @param[in] obstacle why the forces are not computed in batches; empty: they are
  void tell(const LAMMPS_NS::LAMMPS& lmp, const std::string& who, const std::string& obstacle);

 private:
  std::string told_;
};

} // namespace ContactModels
} // namespace LIGGGHTS
