// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How the surface of each particle moves from step to step.
#pragma once

#include "separation/motion_clocks.h"

#include <vector>

namespace LAMMPS_NS {
class Atom;
}

namespace ellipsoid_host {

class SurfaceMotions {
 public:
  /// Measures the motion since the last call, of owned and ghost particles.
  /// @param[in] new_lists the indices of the particles may have changed: all clocks start anew
  /// @return whether the clocks did (also when the number of particles has changed)
  bool update(const LAMMPS_NS::Atom& atom, double time_step, bool new_lists);
  ellipsoid::MotionClocks& clocks() { return clocks_; }

 private:
  std::vector<double> centres_, orientations_; // at the last call: 3 and 4 numbers each
  std::vector<double> turning_radii_;
  ellipsoid::MotionClocks clocks_;

  void restart(const LAMMPS_NS::Atom& atom, double time_step, std::size_t count);
};

} // namespace ellipsoid_host
