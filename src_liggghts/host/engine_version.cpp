// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "engine_version.h"

#include "math/package_version.h"

#include "version_liggghts.h"

#include <cstdio>
#include <mpi.h>
#include <string>
#ifdef LAMMPS_VTK
#include <vtkVersion.h>
#endif

namespace ellipsoid {

namespace {

std::string vtk_name() {
#ifdef LAMMPS_VTK
  return VTK_VERSION;
#else
  return "none";
#endif
}

/// "Open MPI v4.1.4": the first of the words that the library says of itself.
std::string mpi_name() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);
  const std::string all(text, length);
  return all.substr(0, all.find_first_of(",\n"));
}

} // namespace

bool print_version_if_asked(int argument_count, char** arguments) {
  const std::string asked = argument_count == 2 ? arguments[1] : "";
  if (asked != "--version" && asked != "-version")
    return false;
  std::printf("liggghts-ellipsoid %s\nhost      %s\ncompiler  %s\nMPI       %s\nVTK       %s\n",
              package_version, LIGGGHTS_VERSION, compiler_name().c_str(), mpi_name().c_str(),
              vtk_name().c_str());
  return true;
}

} // namespace ellipsoid
