// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A rigid body made of any spheres, as particles have it: its spheres about its centre of mass and
// along its principal axes, without size.
#pragma once

#include "multisphere/clump.h"
#include "multisphere/sphere_list.h"

namespace ellipsoid {

/// A body's moments count as equal, and its axes as principal ones, to this share of their sum.
constexpr double principal_rounding = 1e-9;

/// The number of a particle's spacing (dump column f_spacing) is this and the clump's number, from
/// 1 in the order of the templates, where the particle is a clump.
constexpr int clump_spacing = 1000;
constexpr int largest_clump_number = 999;

struct ClumpTemplate {
  SphereSet spheres; ///< in the body's frame, in lengths of semiaxes.y
  /// How far the spheres reach along the body's x, y, z at most, to either side (length): what
  /// particles have as semi-axes. The second one is a particle's size.
  Vector3 semiaxes;
  double bounding_radius = 0.0; ///< about the centre of mass (length)
  double volume = 0.0;          ///< of the union (length^3)
  double surface = 0.0;         ///< of the union (length^2)
  Vector3 moments;              ///< of the union about x, y, z, density 1 (length^5)
  /// Whether the union's centre of mass is the origin and the axes are its principal ones, to six
  /// digits: not so, perhaps, where the list says that its frame is the body's.
  bool is_principal = true;
  int equal_spheres = 0; ///< how many of the list's spheres equal an earlier one: left out
};

/// A list's clump, equal spheres counted once. Its centre of mass and principal axes are those of
/// the union, density constant, unless the list's frame is the body's. The axes of the list stay
/// where they are principal ones already; else the moments ascend from x to z, and x and y point to
/// where the farthest sphere is.
/// @throws std::invalid_argument bad, or disconnected spheres
ClumpTemplate make_clump(const SphereList& list);

/// Whether two clumps have the same spheres, of the same size, to rounding.
bool are_same(const ClumpTemplate& first, const ClumpTemplate& second);

/// Whether a particle of these semi-axes may be this clump, of whatever size: to six digits.
bool has_shape_of(const ClumpTemplate& clump, const Vector3& semiaxes);

} // namespace ellipsoid
