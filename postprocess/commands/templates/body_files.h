// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Files that `template` writes of one body of spheres, whatever made it.
#pragma once

#include "template_files.h"

#include <string>

namespace ellipsoid::post {

struct BodyFiles {
  double mass = 0.0;                          ///< of the body (kg); 0: not given
  std::string multisphere, molecule, spheres; ///< paths; empty: not written
};

/// @param[in] body about its centre of mass
/// @param[in] spheres of the same body in the frame that the CSV file keeps
void write_body_files(const BodyFiles& files, const SphereBody& body, const SphereSet& spheres);

/// Writes nothing where the path is empty.
void write_if_named(const std::string& path, const std::string& text);

} // namespace ellipsoid::post
