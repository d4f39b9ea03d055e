// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Integrals along arcs of circles on the unit sphere, in closed form; used by sphere_patch.cpp.
#pragma once

#include "multisphere/sphere_patch.h"

#include <cmath>

namespace ellipsoid {

struct AngleInterval {
  double from = 0.0, to = 0.0; ///< (rad), counter-clockwise about the cap's normal
};

/// The circle of a cap, with angles from the side of the pole.
struct CapCircle {
  /// @param[in] pole_direction unit vector, the pole of the form that gives the solid angle
  CapCircle(const SphereCap& of_cap, const Vector3& pole_direction);

  double angle_of(const Vector3& point) const {
    return std::atan2(dot(point, second), dot(point, first));
  }

  SphereCap cap;
  Vector3 first, second;    ///< of the plane's axes, the first on the pole's side
  double radius = 0.0;      ///< of the circle
  double pole_cosine = 0.0; ///< between normal and pole
  double pole_sine = 0.0;   ///< >= 0
};

/// Sums over the arcs, the patch on the outside of each cap.
struct BoundaryIntegrals {
  double pole_form = 0.0;                ///< of (1 - cos t) df
  Vector3 flow;                          ///< of the conormal v, which points into the cap
  SymmetricMatrix3 flow1;                ///< of v x + x v
  std::array<SymmetricMatrix3, 3> flow2; ///< of v x x + x v x + x x v
};

void add_arc(BoundaryIntegrals& sum, const CapCircle& circle, const AngleInterval& arc);

/// @param[in] has_opposite_point whether the patch holds the point opposite to the pole
PatchIntegrals patch_of(const BoundaryIntegrals& boundary, bool has_opposite_point);

} // namespace ellipsoid
