// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

namespace ellipsoid {

/// `liggghts --version`: prints the versions of this package, the host, the compiler, VTK and MPI.
/// False, and nothing is printed, where the arguments ask for something else.
bool print_version_if_asked(int argument_count, char** arguments);

} // namespace ellipsoid
