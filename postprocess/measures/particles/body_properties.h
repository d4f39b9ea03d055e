// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

namespace ellipsoid::post {

/// Volume of an ellipsoid or of the union of a body's spheres (length^3), exact to rounding.
double body_volume(const ParticleSet& set, const Particle& particle);

/// Radius of the ball of the same volume (length).
double volume_radius(double volume);

/// Inertia about the centre in the space frame (mass length^2): of the columns inertiax.. where the
/// file has them; else of a clump's template; of the homogeneous union of the spheres for the
/// host's bodies that are no chains; of the solid ellipsoid with the particle's semi-axes for all
/// others: with it the engine moves chains of spheres, too, and `template --multisphere` the
/// host's.
SymmetricMatrix3 body_inertia(const ParticleSet& set, const Particle& particle, double mass);

} // namespace ellipsoid::post
