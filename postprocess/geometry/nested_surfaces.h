// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "closed_mesh.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// The surface of one body from closed surfaces that share no edges: one that holds all others is
/// turned outwards, those within it are its hollows and are turned the other way.
/// Throws InputError in one line when there are several bodies, or surfaces that cut each other
/// (seen at some corners of each).
std::vector<Triangle3> surface_of_one_body(const std::vector<Triangle3>& triangles,
                                           const std::string& name);

} // namespace ellipsoid::post
