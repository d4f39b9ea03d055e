// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A set of spheres anywhere: what clumps and templates that are no chain are made of.
//
// Conventions:
//  - centres are in the body's frame; which frame that is says who makes the set;
//  - lengths in any consistent unit; nothing here has an absolute length scale;
//  - the body is the union of the spheres, which may overlap in any way.
#pragma once

#include "math/vector3.h"

#include <vector>

namespace ellipsoid {

/// More spheres than this in one set are refused: a bound on what is kept per template and on
/// numbers of spheres, far beyond any use in contacts.
constexpr int largest_set_count = 9999;

struct SphereSet {
  std::vector<Vector3> centres; ///< (length), N values
  std::vector<double> radii;    ///< (length), N values

  int count() const { return static_cast<int>(centres.size()); }
};

/// Leaves out each sphere that equals an earlier one: some programs write a sphere several times,
/// and each contact of two equal spheres would count twice.
/// @return how many were left out
int leave_out_equal_spheres(SphereSet& set);

/// What a body's spheres may be, equal ones or not: 1 to largest_set_count spheres, as many radii
/// as centres, all finite, radii > 0.
/// @throws std::invalid_argument one line: which sphere (from 1), value, allowed range, remedy
void check_values(const SphereSet& set);

/// A set that contacts, measures and searches can be made of: check_values(), and no two equal.
/// @throws std::invalid_argument one line: which sphere (from 1), value, allowed range, remedy
void check_spheres(const SphereSet& set);

/// Number of the connected part that each sphere belongs to, from 0, in the order of each part's
/// first sphere; spheres that touch or overlap are connected.
std::vector<int> connected_parts(const SphereSet& set);

/// Smallest n of from, from + step, ... so that the first n spheres are connected; 0 if none is.
int connected_count(const SphereSet& set, int from, int step);

/// @throws std::invalid_argument the spheres are not one connected body: how many parts, the first
///         sphere (from 1) that is apart, and its gap to the part of the first sphere
void check_connected(const SphereSet& set);

} // namespace ellipsoid
