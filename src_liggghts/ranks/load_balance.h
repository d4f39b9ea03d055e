// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Where the host lets fix balance/ellipsoid shift the planes between sub-domains.
#ifndef LOAD_BALANCE_H_
#define LOAD_BALANCE_H_

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

/// To be called when neighbour lists are about to be built, after the last fix has done its
/// pre_exchange() or setup_pre_exchange().
void balance_ranks(LAMMPS_NS::LAMMPS* lmp);

/// To be called while a restart file is read, before its particles, with what each fix wrote: takes
/// the planes of the run that wrote them, if the processor grid is the same.
void take_planes(LAMMPS_NS::LAMMPS* lmp, const char* fix_style, const char* state);

} // namespace ellipsoid_host

#endif
