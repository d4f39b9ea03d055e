// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

namespace ellipsoid::post {

/// Volume of the union of a body's parts (length^3). Exact for ellipsoids and for spheres with
/// their centres on one line, to rounding for any other union of spheres.
double body_volume(const ParticleSet& set, const Particle& particle);

/// Radius of the ball of the same volume (length).
double volume_radius(double volume);

/// Inertia about the centre in the space frame (mass length^2), of a solid ellipsoid with the
/// particle's semi-axes, or of a solid clump.
SymmetricMatrix3 body_inertia(const Particle& particle, double mass);

} // namespace ellipsoid::post
