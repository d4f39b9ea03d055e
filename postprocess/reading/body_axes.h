// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How a rigid body of spheres lies, and how long it is along its axes: no file says it of the
// host's bodies.
#pragma once

#include "particles.h"

namespace ellipsoid::post {

struct BodyAxes {
  Quaternion orientation;
  Vector3 semiaxes; ///< half lengths along the body's x, y, z, surfaces included (length)
  KnownOrientation known = KnownOrientation::whole;
};

/// Axes of a body from the places of its spheres. They turn with the body: which of two opposite or
/// equivalent directions is taken depends on the order of the spheres alone, which must be the same
/// in every frame. Round about an axis are bodies whose centres scatter alike across it (a square,
/// a ring, a chain): their half lengths across it are equal. Chains do not tell how they turn about
/// their axis, spheres of one centre do not tell anything.
/// @param[in] centre mean of the centres of the spheres
BodyAxes axes_of_body(const Sphere* begin, const Sphere* end, const Vector3& centre);

} // namespace ellipsoid::post
