// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "command.h"
#include "frame_loop.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// A measure of every particle of a frame.
struct ParticleValues {
  std::string key;            ///< with its unit as the last part
  std::vector<double> values; ///< in the order of the set
};

/// Adds --per-particle.
void add_particle_values_option(CLI::App& command, std::string& path);

/// Writes them to a file: a name that ends in .csv gets a table, one that ends in .dump the frame
/// with the values as further columns, for `render3d`, `paraview` and others. A "*" in the name
/// stands for the time step.
/// Throws InputError for other names, and for a .dump of bodies that take several rows.
void write_particle_values(const std::string& path, const ChosenFrame& chosen,
                           const std::vector<ParticleValues>& columns);

} // namespace ellipsoid::post
