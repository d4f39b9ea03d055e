// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

#include <array>
#include <optional>
#include <vector>

namespace ellipsoid::post {

/// Eigenvalues of a symmetric tensor, descending, and the direction of the largest.
struct PrincipalAxes {
  std::array<double, 3> values{};
  Vector3 direction; ///< unit
};

/// Of the mean of n n^T over unit vectors n.
PrincipalAxes mean_dyad(const std::vector<Vector3>& directions);

/// The axis that tells how a body lies.
enum class BodyAxis {
  none,     ///< a sphere
  longest,  ///< bodies that are longer than wide
  shortest, ///< discs
};

/// By the ratios of the semi-axes s1 >= s2 >= s3: a disc if s1 / s2 < s2 / s3.
BodyAxis body_axis(const Particle& particle);

/// Unit vectors along the longest, middle and shortest semi-axis, wherever they are in the body.
std::array<Vector3, 3> axes_by_length(const Particle& particle);

/// The coordinate plane of angles, by its two axes (0: x, 1: y, 2: z); the first is the direction
/// of the flow.
struct AnglePlane {
  std::size_t first = 0, second = 1;
};

struct Orientation {
  double nematic_order = 0.0; ///< S: largest eigenvalue of <3/2 (n n - I/3)>, 0 random, 1 aligned
  Vector3 director;           ///< unit
  std::optional<double> biaxial_order;   ///< of bodies with three different semi-axes
  double plane_order = 0.0;              ///< S2 = |<exp(2 i theta)>| in the plane
  double plane_angle_deg = 0.0;          ///< of the plane director, 0 to 180
  double flow_angle_deg = 0.0;           ///< mean of theta in (-90, 90]
  double flow_angle_deviation_deg = 0.0; ///< standard deviation of the same
  std::vector<double> rose;              ///< share of particles per bin of theta from 0 to 180 deg
};

/// Order of the axes of some particles: of the longest ones, or of the shortest ones.
Orientation orientation(const ParticleSet& set, const std::vector<std::size_t>& members,
                        BodyAxis axis, int bins, const AnglePlane& plane = {});

/// Shares of directions per bin of their angle in the plane from 0 to 180 degrees.
std::vector<double> angle_rose(const std::vector<Vector3>& directions, int bins,
                               const AnglePlane& plane = {});

} // namespace ellipsoid::post
