// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How far the surface of each particle can have moved since the neighbour lists were built.
#ifndef SURFACE_PATHS_H_
#define SURFACE_PATHS_H_

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
  /// Path (length).
  double operator[](int i) const { return paths_[static_cast<std::size_t>(i)]; }
  /// Grows in every step by the largest growth of all paths (length).
  double bound() const { return bound_; }

private:
  struct Pose {
    double x[3], quaternion[4];
  };
  std::vector<Pose> poses_; // at the last call
  std::vector<double> paths_;
  double bound_ = 0.0;
};

} // namespace LIGGGHTS

#endif
