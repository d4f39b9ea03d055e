// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Rigid bodies of the host's fix multisphere: rows are spheres, a column joins them.
#pragma once

#include "particles.h"

namespace ellipsoid::post {

/// The column that joins rows to bodies, or null. Throws InputError where that is not sure.
Column bodies_column(const NamedColumns& columns, const ParticleOptions& options);

/// Adds the bodies of a frame to a set that knows its box: spheres of a body that lies across a
/// repeating face are put together again. Rows of no body are spheres of their own.
void add_host_bodies(ParticleSet& set, const std::vector<double>& body_of_row,
                     const NamedColumns& columns, const ParticleOptions& options);

} // namespace ellipsoid::post
