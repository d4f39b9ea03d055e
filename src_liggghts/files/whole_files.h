// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Restart and data files that are whole or refused: written under a temporary name and renamed when
// they are complete, and read only if the end that was written is there.
#pragma once

#include "error.h"
#include "lmptype.h"

#include <cstdio>

namespace ellipsoid_host {

/// Opens a file beside `name`, in the same folder, that takes this name when it is finished; until
/// then an older file `name` stays as it is. What is there and is no regular file is opened itself.
/// @return null if it cannot be opened, as fopen()
std::FILE* create_file(const char* name, const char* mode);

/// Appends length, time step and checksum to a file of create_file(), closes it and gives it its
/// name. Stops with one line if anything could not be written.
void finish_restart_file(LAMMPS_NS::Error* error, std::FILE* file, LAMMPS_NS::bigint step);
/// The same with a line of text that marks the end.
void finish_data_file(LAMMPS_NS::Error* error, std::FILE* file);

/// Stops with one line if the file is not as it was written. A file of another LIGGGHTS, which has
/// no checksum, gives a warning. No complaint about a file that cannot be opened.
void check_restart_file(LAMMPS_NS::Error* error, const char* name);
/// The same for a file of one rank (`%` in the name), which must be of the time step `step`.
void check_rank_file(LAMMPS_NS::Error* error, const char* name, LAMMPS_NS::bigint step);
/// Stops with one line if the end of a file of write_data is missing.
void check_data_file(LAMMPS_NS::Error* error, const char* name);

} // namespace ellipsoid_host
