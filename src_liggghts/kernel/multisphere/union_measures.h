// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Volume, surface, centre and moments of a union of spheres, each point counted once.
#pragma once

#include "multisphere/clump.h"

namespace ellipsoid {

struct UnionMeasures {
  double volume = 0.0;  ///< (length^3)
  double surface = 0.0; ///< area of the outside, and of closed hollows (length^2)
  Vector3 centre;       ///< of mass, density constant, in the set's frame (length)
  /// About the centre, axes of the set's frame, density 1 (length^5): xx is the integral of
  /// y^2 + z^2, xy of -x y.
  SymmetricMatrix3 inertia;
};

/// Exact to rounding, by the divergence theorem over the spheres' uncovered parts: relative errors
/// of about 1e-14. O(N) neighbours, O(their number squared) for each at worst.
/// @throws std::invalid_argument as check_spheres()
UnionMeasures measure_union(const SphereSet& set);

} // namespace ellipsoid
