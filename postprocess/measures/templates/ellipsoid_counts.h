// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How many spheres an ellipsoid needs.
#pragma once

#include "math/vector3.h"
#include "multisphere/multisphere_template.h"

namespace ellipsoid::post {

/// What a tolerance is about: the volume in exactly one of set and ellipsoid, as a share of the
/// ellipsoid's; the largest distance between the outlines, either way, in smallest semi-axes.
enum class SetError { volume, outline };

double error_of(const Vector3& semiaxes, int count, SphereSpacing spacing, SetError what);

/// Smallest odd N within the tolerance, found by bisection: errors fall with N but for small steps,
/// so that a somewhat smaller N may do as well. The N given does.
/// @throws std::invalid_argument bad semi-axes, a spacing of chains, or none up to the largest N
int count_within(const Vector3& semiaxes, SphereSpacing spacing, SetError what, double tolerance);

} // namespace ellipsoid::post
