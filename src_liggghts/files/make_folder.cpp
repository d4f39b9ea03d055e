// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "make_folder.h"

#include "comm.h"
#include "error.h"

#include <filesystem>
#include <mpi.h>
#include <string>

using namespace LAMMPS_NS;

/// One process makes the folder; all wait for it, and stop together when it cannot be made.
void MakeFolder::command(int narg, char** arg) {
  if (narg != 1) {
    std::string words;
    for (int k = 0; k < narg; ++k)
      words += std::string(k > 0 ? " " : "") + arg[k];
    error->all(FLERR, ("make_folder takes one path without blanks, not '" + words +
                       "'; choose another name")
                          .c_str());
  }
  int failed = 0;
  std::string reason;
  if (comm->me == 0) {
    std::error_code problem;
    std::filesystem::create_directories(arg[0], problem);
    failed = std::filesystem::is_directory(arg[0]) ? 0 : 1;
    reason = problem ? problem.message() : "there is something else of this name";
  }
  MPI_Bcast(&failed, 1, MPI_INT, 0, world);
  if (failed)
    error->all(FLERR,
               ("make_folder: '" + std::string(arg[0]) + "' cannot be made: " + reason).c_str());
}
