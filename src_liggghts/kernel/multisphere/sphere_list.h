// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Lists of spheres as text: the host's multisphere file, CSV, what CLUMP writes.
#pragma once

#include "multisphere/clump.h"

#include <string>

namespace ellipsoid {

/// How a list says that its frame is the body's: a comment of this text.
constexpr char body_frame_mark[] = "frame: body";

struct SphereList {
  SphereSet spheres;
  /// The frame is the body's: origin in the centre of mass, axes along the principal ones.
  bool is_body_frame = false;
};

/// A sphere a line: x y z r, apart by spaces, tabs, commas or semicolons. Lines that begin with #,
/// % or //, empty ones and what follows a # are left out; so is a first line of words, which says
/// in which columns x, y, z and r (or radius) stand, where there are others.
/// @throws std::invalid_argument one line: which line, what it has, what is needed
SphereList parse_sphere_list(const std::string& text);

/// "x,y,z,r" lines with 17 digits below comments: the title, and body_frame_mark.
std::string body_frame_list(const SphereSet& set, const std::string& title);

} // namespace ellipsoid
