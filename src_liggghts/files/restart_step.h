// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A time step at which `restart N` writes files: the run that writes them and a run that goes on
// from them are the same from there on.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

/// To be called at the end of a time step, before its output: if restart files are due, writes
/// them, and sets the run up as `read_restart` and `run` would. Only with pair_style
/// gran/ellipsoid.
void go_on_as_from_restart_file(LAMMPS_NS::LAMMPS* lmp);

/// After a restart file was written: shrink-wrapped boundaries have the present box as the least
/// one from now on, as after `read_restart`. Only with pair_style gran/ellipsoid.
void begin_from_present_box(LAMMPS_NS::LAMMPS* lmp);

} // namespace ellipsoid_host
