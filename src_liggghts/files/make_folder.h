// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
// make_folder: a folder for results, with the folders above it, made without a shell
// (doc/command_make_folder.md).
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(make_folder,MakeFolder)
// clang-format on
#else
#ifndef LMP_MAKE_FOLDER_H
#define LMP_MAKE_FOLDER_H

#include "pointers.h"

namespace LAMMPS_NS {

class MakeFolder : protected Pointers {
 public:
  explicit MakeFolder(class LAMMPS* lmp) : Pointers(lmp) {}
  void command(int narg, char** arg);
};

} // namespace LAMMPS_NS

#endif
#endif
