// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The arguments of fix wall/gran/ellipsoid: checked before the host reads them, and what is needed
// of them that the host keeps to itself.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

/// The cylinder of a primitive wall, as the command gives it.
struct WallCylinder {
  int axis = -1;                      ///< 0, 1, 2; -1: the wall is a plane, or meshes
  double radius = 0.0;                ///< length
  double centre[3] = {0.0, 0.0, 0.0}; ///< a point of the axis (length)
};

/// The host reads these arguments without looking whether the words are there, and says little
/// about wrong ones. Stops with one line where one is missing or wrong.
/// @param[in] narg, arg all arguments of the command
WallCylinder check_wall_command(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

/// The names of the models and their settings, on which the history of the contacts depends;
/// without the place, motion and temperature of the wall.
/// @param[in] settings index of the first argument behind those that the host has read
std::string wall_law(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, int settings);

/// What the wall is: 'zplane', 'xcylinder', or 'meshes ID ...'.
std::string wall_kind(int narg, char** arg);

} // namespace ellipsoid_host
