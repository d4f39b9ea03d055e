// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

#include <vector>

namespace ellipsoid::post {

/// Points spread evenly over the unit sphere (Fibonacci's spiral), at least four.
std::vector<Vector3> directions_on_sphere(std::size_t count);

/// Points of a body's surface moved inwards along the normal by `depth` (length), no more than
/// about `spacing` apart (length). Of spheres those parts that lie in no other sphere of the body.
/// @param[in] depth less than the body's smallest radius of curvature
std::vector<Vector3> surface_points_of(const ParticleSet& set, const Particle& particle,
                                       double depth, double spacing);

/// Smallest radius of curvature of a body's parts (length).
double smallest_curvature_radius(const ParticleSet& set, const Particle& particle);

} // namespace ellipsoid::post
