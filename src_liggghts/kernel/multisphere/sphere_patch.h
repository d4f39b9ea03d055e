// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What is left of a unit sphere when caps are cut off, and integrals over it, exact.
#pragma once

#include "math/vector3.h"

#include <array>
#include <vector>

namespace ellipsoid {

/// The cap normal . x > height of the unit sphere about the origin.
struct SphereCap {
  Vector3 normal;      ///< unit vector
  double height = 0.0; ///< in (-1, 1)
};

/// Integrals over a part of the unit sphere of 1, n, n n and n n n, n its outer normal.
struct PatchIntegrals {
  double solid_angle = 0.0;
  Vector3 first;
  SymmetricMatrix3 second;
  std::array<SymmetricMatrix3, 3> third; ///< of n n x, n n y, n n z
};

/// Integrals over the part of the unit sphere that lies in none of the caps.
///
/// By Stokes's theorem from the arcs of the caps' circles that lie in no other cap: the solid angle
/// from the form (1 - cos t) df about a pole t = 0, the others from spherical harmonics of degree
/// l, whose integral is the flow of their gradient through the boundary over -l(l + 1). Arcs need
/// not be linked to outlines, so that circles may touch and any number may meet in a point. Error:
/// some rounding units of the whole sphere's values.
/// @param[in] caps in any order; equal ones and such that touch are allowed
PatchIntegrals uncovered_patch(std::vector<SphereCap> caps);

} // namespace ellipsoid
