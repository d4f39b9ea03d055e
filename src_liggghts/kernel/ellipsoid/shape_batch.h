// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The shapes of many turned ellipsoids at once: make_shape() in a loop that the compiler turns into
// vector instructions. The results are those of the function, bit for bit.
#pragma once

#include "ellipsoid/ellipsoid_contact.h"

namespace ellipsoid {

/// Rows of numbers, one row per ellipsoid.
struct ShapeRows {
  const double* semiaxes;     ///< 3 each: a, b, c along the body's x, y, z (length, > 0)
  const double* orientations; ///< 4 each: unit quaternion, scalar first, body to space
  EllipsoidShape* shapes;     ///< one each: made by make_shapes()
};

/// Makes the shapes of all ellipsoids.
void make_shapes(ShapeRows rows, int count);

} // namespace ellipsoid
