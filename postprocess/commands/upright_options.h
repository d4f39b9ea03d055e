// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_options.h"
#include "height_map.h"

namespace ellipsoid::post {

/// Adds --up y|z to a command on 3D heaps and beds.
void add_up_option(CLI::App& command, std::string& up);

/// The particles with z upwards.
ParticleSet upright(const ParticleSet& set, const std::string& up);

} // namespace ellipsoid::post
