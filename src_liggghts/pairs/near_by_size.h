// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Where the host's neighbour lists take their candidates from when particles have many sizes: its
// bins are as wide as the largest particle needs.
#ifndef ELLIPSOID_NEAR_BY_SIZE_H
#define ELLIPSOID_NEAR_BY_SIZE_H

#include "neighbours/size_grids.h"

#include <cstddef>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

class NearBySize {
 public:
  /// For a new list.
  /// @return whether it should be used: the bins serve particles of about one size
  bool begin(const LAMMPS_NS::LAMMPS& lmp);
  /// The first particle after i that is near it; -1: there is none.
  int first(int i) {
    found_ = &grids_.find(i);
    at_ = 0;
    return next();
  }
  int next() { return at_ < found_->size() ? (*found_)[at_++] : -1; }

 private:
  ellipsoid::SizeGrids grids_;
  const std::vector<int>* found_ = nullptr;
  std::size_t at_ = 0;
};

/// To be asked for each particle of a list from 0 on; null: the host's bins serve, as they do for
/// all other pair styles.
NearBySize* near_by_size(LAMMPS_NS::LAMMPS* lmp, int i);

} // namespace ellipsoid_host

#endif
