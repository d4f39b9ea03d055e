// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// An ellipsoid of any three semi-axes approximated by N spheres: the set for each spacing.
//
// The centres of the largest inscribed spheres of an ellipsoid a >= b >= c, semi-axes along x, y,
// z, fill the ellipse z = 0, x^2/p^2 + y^2/q^2 <= 1, p = (a^2 - c^2)/a, q = (b^2 - c^2)/b, its
// medial surface; their radii are R^2 = c^2 (1 - x^2/(a^2 - c^2) - y^2/(b^2 - c^2)). For b = c that
// is the axis, and Markauskas et al. 2010, eq. (4).
#pragma once

#include "multisphere/clump.h"
#include "multisphere/multisphere_template.h"

namespace ellipsoid {

/// The set of N spheres, centred on the origin, semi-axes along the body's x, y, z in any order of
/// size. The same numbers for the same arguments; scales with the unit of length.
///
/// `medial`: inscribed spheres, the centre first, then always where the gap to the ellipsoid is
/// largest, in pairs on the ellipse's axes and in fours elsewhere, a four as two pairs of which
/// each lies opposite about the centre. The set of N + 2 begins with that of N, for all N. An even
/// N has no sphere in the centre: it begins with a pair on the longest axis, as far apart as the
/// largest gap stays within 1.25 times the smallest possible one, and a pair there divides what
/// lies between the two innermost ones into three when the gap at the shortest axis is the largest.
/// Sets have the ellipsoid's three planes of symmetry but where N cuts a four: then the plane of
/// the two larger semi-axes and the centre.
///
/// `minimax_volume`: from inscribed spheres centres in the same plane and radii, for which the
/// volume in exactly one of body and ellipsoid is smallest (a local minimum), with the three planes
/// of symmetry, so that centre and principal axes are the ellipsoid's. All other spacings are
/// make_multisphere()'s: a > b = c, a along the body's x.
/// @param[in] count N up to largest_set_count (largest_sphere_count for others than `medial`); odd
///            for chains
/// @throws std::invalid_argument one line: what, value, allowed range, remedy
SphereSet make_ellipsoid_spheres(const Vector3& semiaxes, int count, SphereSpacing spacing);

/// The same for the two planar spacings without the check of is_one_body().
SphereSet place_ellipsoid_spheres(const Vector3& semiaxes, int count, SphereSpacing spacing);

/// Whether the spheres are connected and one of them holds the origin.
bool is_one_body(const SphereSet& set);

/// The largest N of a spacing.
int largest_count_of(SphereSpacing spacing);

/// The spheres of a chain in space, from -x to +x.
SphereSet spheres_of(const MultisphereTemplate& chain);

} // namespace ellipsoid
