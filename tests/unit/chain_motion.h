// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// How a chain of spheres moved in a step, one body at a time: beside the batches of the kernel.
#pragma once

#include "multisphere/multisphere_contact.h"
#include "separation/motion_clocks.h"

#include <cmath>

namespace ellipsoid {

/// Motion of a body in a step.
/// @param[in] displacement of its centre (length)
inline Motion motion(const MultispherePose& before, const MultispherePose& after,
                     const Vector3& displacement) {
  const MultisphereBody& chain = *after.body;
  const double grown = std::fabs(after.scale - before.scale);
  return {displacement, after.scale * chain.half_length() * norm(after.axis - before.axis) +
                            grown * (chain.half_length() + chain.largest_radius())};
}

} // namespace ellipsoid
