// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The spheres of all particles: chains, other sets inside an ellipsoid, or clumps.
#pragma once

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

/// What a script says again for the sub-spheres that particles of a restart file have.
constexpr char repeat_after_restart[] =
    "repeat the templates with 'subspheres' or 'clump', or give 'fix subspheres all property/atom "
    "subspheres scalar yes yes no 0.' and 'fix spacing all property/atom spacing scalar yes yes no "
    "0.'";

/// Which body a particle has is stored per atom: fix property/atom `subspheres` (N) and `spacing`
/// (the number of SphereSpacing, or of a clump; all 0 if that fix is missing). Particles of equal
/// aspect ratios, N and spacing share their spheres, particles of a clump its spheres.
class MultisphereParticles : private LAMMPS_NS::Pointers {
 public:
  explicit MultisphereParticles(LAMMPS_NS::LAMMPS* lmp) : Pointers(lmp) {}

  /// When ghosts are new, on all ranks, before the neighbour lists are made: gets their values.
  void ghosts_are_new();
  /// What an owned or ghost particle lies within.
  ellipsoid::BodyBounds bounds(int i);
  /// Poses of all owned and ghost particles; to be called once per time step, on all ranks.
  /// @return whether the neighbour lists are new: what is remembered of particles is to be
  /// forgotten
  bool update();
  const ellipsoid::MultispherePose& pose(int i) const {
    return poses_[static_cast<std::size_t>(i)];
  }
  ellipsoid::MotionClocks& clocks() { return clocks_; }
  /// For make_pose() without update(): to be called once per time step.
  void find_properties();
  /// Pose of one owned particle.
  ellipsoid::MultispherePose make_pose(int i);
  /// Pose of a particle that may be no atom.
  /// @throws std::invalid_argument these semi-axes have no such body
  ellipsoid::MultispherePose make_pose(const double* semiaxes, const double* quaternion, int count,
                                       int spacing);

 private:
  /// a/b and c/b in units of 1e-12, N, spacing
  using Key = std::tuple<long long, long long, int, int>;
  std::map<Key, std::unique_ptr<ellipsoid::MultisphereBody>> bodies_;
  std::vector<ellipsoid::MultispherePose> poses_;
  std::vector<double> centres_; // at the last update: 3 numbers each
  ellipsoid::MotionClocks clocks_;
  LAMMPS_NS::FixPropertyAtom* subspheres_ = nullptr;
  LAMMPS_NS::FixPropertyAtom* spacing_ = nullptr;

  const ellipsoid::MultisphereBody* body(int i);
  const ellipsoid::MultisphereBody* body(const double* semiaxes, int count, int spacing);
  void begin_lists(std::size_t count);
  void move();
  void set_pose(int i, ellipsoid::MultispherePose& pose) const;
};

} // namespace ellipsoid_host
