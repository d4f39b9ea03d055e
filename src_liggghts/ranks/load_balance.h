// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Where the host lets fix balance/ellipsoid shift the planes between sub-domains.
#pragma once

#include "sub_domains.h"

namespace ellipsoid_host {

/// To be called when neighbour lists are about to be built, after the last fix has done its
/// pre_exchange() or setup_pre_exchange().
void balance_ranks(LAMMPS_NS::LAMMPS* lmp);

/// To be called while a restart file is read, before its particles, with what each fix wrote:
/// restores the planes of the run that wrote them, if the processor grid is the same.
void restore_planes(LAMMPS_NS::LAMMPS* lmp, const char* fix_style, const char* state);

/// While it exists, sub-domains are even for a fix that is made, if it is one that inserts: such
/// fixes measure then what part of their region each rank has.
class EvenPlanes {
 public:
  EvenPlanes(LAMMPS_NS::LAMMPS* lmp, const char* fix_style);
  ~EvenPlanes();
  EvenPlanes(const EvenPlanes&) = delete;
  EvenPlanes& operator=(const EvenPlanes&) = delete;

 private:
  LAMMPS_NS::LAMMPS* lmp_ = nullptr; // null: nothing to do
  Planes present_;
};

} // namespace ellipsoid_host
