// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

namespace ellipsoid::post {

/// All images of the particles that reach into a rectangular part of space; where the box does not
/// repeat, the particles as they are.
/// @param[in] lower, upper corners of the part (length)
/// Throws InputError for a part that is very much larger than the box.
ParticleSet with_images(const ParticleSet& set, const Vector3& lower, const Vector3& upper);

/// Throws InputError where the box repeats along one of two axes (0: x, 1: y, 2: z), along which
/// `what`, for example "a heap", has to end.
void refuse_repeating(const Box& box, std::size_t first, std::size_t second, const char* what);

} // namespace ellipsoid::post
