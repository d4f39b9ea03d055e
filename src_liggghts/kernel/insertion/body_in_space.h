// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Whether a body lies wholly in a part of space of any shape, of which only the distance to its
// surface is known.
#pragma once

#include "insertion/solid_body.h"
#include "math/vector3.h"

#include <functional>

namespace ellipsoid {

/// How far a point is from leaving the space (length); negative: it is outside. Must not be too
/// large; may end at `enough`.
using RoomAround = std::function<double(const Vector3& point, double enough)>;

/// Bodies that come closer to the surface than this share of their largest semi-axis, or of the
/// radius of a sphere, may be told to be outside; none that is outside is told to be inside.
constexpr double undecided_share = 1e-4;

bool is_inside_space(const SolidBody& body, const RoomAround& room);

} // namespace ellipsoid
