// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Gravity and the axis that points up: given, or from the run's log, or a default that is said.
#pragma once

#include "command.h"
#include "frame_loop.h"
#include "height_map.h"

#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Adds --gravity: gx gy gz, or the magnitude alone, downwards.
void add_gravity_option(CLI::App& command, std::vector<double>& gravity);

/// Gravity of a frame.
struct Gravity {
  double magnitude = 9.81;       ///< (m/s2)
  std::optional<Vector3> vector; ///< (m/s2); none: its direction is not known
  std::string source;            ///< "option", "log", "assumed"
};

/// From the option; else of the log beside the dump; else 9.81 along -y for particles in one plane
/// z, of unknown direction for others.
Gravity gravity_of(const std::vector<double>& option, const ChosenFrame& chosen);

/// Its components and where they come from, as columns of a table.
void append_gravity(Row& row, const Gravity& gravity);

/// Adds --up y|z to a command on heaps, beds and pictures in space.
void add_up_option(CLI::App& command, std::string& up);

/// The axis that points up.
struct UpDirection {
  UpAxis axis = UpAxis::z;
  std::string source; ///< as of Gravity
};

/// From the option; else against the log's gravity; else z.
/// Throws InputError where gravity of the log is along no axis that can point up.
UpDirection up_direction(const std::string& option, const ChosenFrame& chosen);

void append_up(Row& row, const UpDirection& up);

} // namespace ellipsoid::post
