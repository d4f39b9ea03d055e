// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Where the host's neighbour lists take their candidates from when its bins serve badly: these are
// as wide as the bounding sphere of the largest or longest particle needs.
//
// Candidates by true shape are the pairs that are nearer than two margins. They are good until a
// particle's surface has moved by more than a margin, rotation included: then the lists have to be
// made anew.
#pragma once

#include "neighbours/long_bodies.h"
#include "neighbours/size_grids.h"

#include <cstddef>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

class SurfaceContacts;

class NearCandidates {
 public:
  /// Before new lists are made, on all ranks together: whether bodies are so long or flat that
  /// pairs are chosen by true shape, and by what margin.
  void prepare(LAMMPS_NS::LAMMPS& lmp);
  /// For a new list; to be asked for each of its particles from 0 on.
  /// @param[in] contacts which know the bounds of all particles, ghosts too
  /// @return whether this should be used: the bins serve compact particles of about one size
  bool serve(int i, const LAMMPS_NS::LAMMPS& lmp, SurfaceContacts& contacts) {
    if (i == 0)
      serve_ = begin(lmp, contacts);
    return serve_;
  }
  /// The first particle after i that is near it; -1: there is none.
  int first(int i) {
    found_ = by_shape_ ? &bodies_.find(i) : &grids_.find(i);
    at_ = 0;
    return next();
  }
  int next() { return at_ < found_->size() ? (*found_)[at_++] : -1; }

  /// After particles have moved, on all ranks together: whether the lists may lack a pair that
  /// touches now.
  bool are_outdated(const LAMMPS_NS::LAMMPS& lmp) const;

 private:
  ellipsoid::SizeGrids grids_;
  ellipsoid::LongBodies bodies_;
  const std::vector<int>* found_ = nullptr;
  std::size_t at_ = 0;
  bool serve_ = false, by_shape_ = false;
  double margin_ = 0.0;                        // (length)
  std::vector<ellipsoid::BodyBounds> bounds_;  // of all particles when the lists were made
  std::vector<double> centres_, orientations_; // of owned ones at that time

  bool begin(const LAMMPS_NS::LAMMPS& lmp, SurfaceContacts& contacts);
  bool moved_too_far(const LAMMPS_NS::LAMMPS& lmp) const;
};

/// To be asked for each particle of a list from 0 on; null: the host's bins serve, as they do for
/// all other pair styles.
NearCandidates* near_candidates(LAMMPS_NS::LAMMPS* lmp, int i);

} // namespace ellipsoid_host
