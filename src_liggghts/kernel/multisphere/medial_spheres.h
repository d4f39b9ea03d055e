// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Placing of spheres on the medial ellipse; other code calls make_ellipsoid_spheres().
#pragma once

#include "math/vector3.h"

#include <vector>

namespace ellipsoid {

/// Semi-axes a >= b >= c > 0 along x, y, z (length).
struct SortedSemiaxes {
  double a = 1.0, b = 1.0, c = 1.0;
};

/// A sphere in the plane z = 0 and its mirror images at x = 0 and y = 0: 1, 2 or 4 spheres.
struct MirroredSphere {
  double x = 0.0, y = 0.0; ///< >= 0 (length)
  double radius = 0.0;     ///< (length)

  int count() const { return (x > 0.0 ? 2 : 1) * (y > 0.0 ? 2 : 1); }
};

/// The inscribed sphere that touches the ellipsoid in (a w.x, b w.y, c w.z), |w| = 1, w >= 0.
MirroredSphere inscribed_sphere(const SortedSemiaxes& axes, const Vector3& w);

/// Levels of spacing `medial` that hold N = count spheres; up to two more where the last four is
/// cut. Those of a larger N of the same parity begin with the same levels. For an odd N the first
/// one is the sphere in the centre, for an even N a pair on the longest axis.
std::vector<MirroredSphere> medial_levels(const SortedSemiaxes& axes, int count);

/// As medial_levels(), but just N = count spheres: where four are next and two are left to place,
/// the best pair on an axis is taken. For an even N the set of N - 1 with a pair on the longest
/// axis instead of the centre sphere.
std::vector<MirroredSphere> mirrored_medial_spheres(const SortedSemiaxes& axes, int count);

/// Spacing `minimax_volume` for N = count; an even N has no sphere in the centre.
std::vector<MirroredSphere> minimax_volume_spheres(const SortedSemiaxes& axes, int count);

} // namespace ellipsoid
