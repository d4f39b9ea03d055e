// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

#include <array>
#include <vector>

namespace ellipsoid::post {

/// Eigenvalues of a symmetric tensor, descending, and the direction of the largest.
struct PrincipalAxes {
  std::array<double, 3> values{};
  Vector3 direction; ///< unit
};

/// sum of w n n^T as a tensor from unit vectors n, divided by their number.
PrincipalAxes mean_dyad(const std::vector<Vector3>& directions);

struct Orientation {
  double nematic_order = 0.0;   ///< S: largest eigenvalue of <3/2 (n n - I/3)>, 0 random, 1 aligned
  Vector3 director;             ///< unit
  double plane_order = 0.0;     ///< S2 = |<exp(2 i theta)>| in the xy plane
  double plane_angle_deg = 0.0; ///< of the plane director, 0 to 180
  std::vector<double> rose;     ///< share of particles per bin of theta from 0 to 180 deg
};

/// Order of the long axes, see Particle::long_axis().
Orientation orientation(const ParticleSet& set, const std::vector<std::size_t>& members, int bins);

/// Shares of directions per bin of their angle in the xy plane from 0 to 180 degrees.
std::vector<double> angle_rose(const std::vector<Vector3>& directions, int bins);

} // namespace ellipsoid::post
