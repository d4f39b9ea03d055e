// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How far the surface of each particle can have moved since the neighbour lists were built.
#ifndef SURFACE_PATHS_H_
#define SURFACE_PATHS_H_

#include "sleeping_pairs.h"

#include <vector>

namespace LAMMPS_NS {
class Atom;
}

namespace LIGGGHTS {

/// The path of a particle grows in every step by the way of its centre and by the angle it turned
/// times its bounding radius: no point of its surface has moved farther, whatever moved it.
class SurfacePaths {
public:
  /// Adds the motion since the last call; owned and ghost particles.
  /// @param[in] new_lists the indices of the particles may have changed: all paths are 0 again
  /// @return whether the paths are 0 again (also when the number of particles has changed)
  bool update(const LAMMPS_NS::Atom& atom, bool new_lists);
  const ellipsoid::Travels& travels() const { return travels_; }

private:
  struct Pose {
    double x[3], quaternion[4];
  };
  std::vector<Pose> poses_; // at the last call
  ellipsoid::Travels travels_;
};

} // namespace LIGGGHTS

#endif
