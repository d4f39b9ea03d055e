// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The chains of spheres of all particles.
#ifndef ELLIPSOID_MULTISPHERE_PARTICLES_H
#define ELLIPSOID_MULTISPHERE_PARTICLES_H

#include "multisphere/multisphere_contact.h"
#include "pointers.h"
#include "separation/motion_clocks.h"

#include <array>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace LAMMPS_NS {
class FixPropertyAtom;
class Modify;
} // namespace LAMMPS_NS

namespace ellipsoid_host {

/// The per-atom fixes `subspheres` and `spacing`; null where missing.
using SubsphereProperties = std::array<LAMMPS_NS::FixPropertyAtom*, 2>;
SubsphereProperties subsphere_properties(LAMMPS_NS::Modify* modify);
/// The same, made where missing. They go with the atoms to other ranks and restart files.
SubsphereProperties make_subsphere_properties(LAMMPS_NS::Modify* modify);

/// Which chain a particle has is stored per atom: fix property/atom `subspheres` (N) and `spacing`
/// (the number of SphereSpacing; all 0 if that fix is missing). Particles of equal aspect ratio,
/// N and spacing share one chain.
class MultisphereParticles : private LAMMPS_NS::Pointers {
 public:
  explicit MultisphereParticles(LAMMPS_NS::LAMMPS* lmp) : Pointers(lmp) {}

  /// Poses of all owned and ghost particles; to be called once per time step, on all ranks.
  /// @return whether the neighbour lists are new: what is remembered of particles is to be
  /// forgotten
  bool update();
  const ellipsoid::ChainPose& pose(int i) const { return poses_[static_cast<std::size_t>(i)]; }
  ellipsoid::MotionClocks& clocks() { return clocks_; }
  /// For make_pose() without update(): to be called once per time step.
  void find_properties();
  /// Pose of one owned particle.
  ellipsoid::ChainPose make_pose(int i);
  /// Pose of a particle that may be no atom.
  /// @throws std::invalid_argument these semi-axes have no such chain
  ellipsoid::ChainPose make_pose(const double* semiaxes, const double* quaternion, int count,
                                 int spacing);

 private:
  using Key = std::tuple<long long, int, int>; // aspect ratio in units of 1e-12, N, spacing
  std::map<Key, std::unique_ptr<ellipsoid::SphereChain>> chains_;
  std::vector<ellipsoid::ChainPose> poses_;
  std::vector<double> centres_; // at the last update: 3 numbers each
  ellipsoid::MotionClocks clocks_;
  LAMMPS_NS::FixPropertyAtom* subspheres_ = nullptr;
  LAMMPS_NS::FixPropertyAtom* spacing_ = nullptr;

  const ellipsoid::SphereChain* chain(int i);
  const ellipsoid::SphereChain* chain(const double* semiaxes, int count, int spacing);
  void begin_lists(std::size_t count);
  void move();
  void place(int i, ellipsoid::ChainPose& pose) const;
};

} // namespace ellipsoid_host

#endif
