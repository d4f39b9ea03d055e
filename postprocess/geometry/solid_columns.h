// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Solids as columns along z: what two of them have in common.
#pragma once

#include "math/vector3.h"
#include "multisphere/clump.h"

#include <array>
#include <vector>

namespace ellipsoid::post {

/// A part of a column, from z = from to z = to (length).
struct ColumnPart {
  double from = 0.0, to = 0.0;
};
/// Disjoint parts, ascending.
using ColumnParts = std::vector<ColumnPart>;

/// A grid of columns over a rectangle of the xy plane.
struct ColumnGrid {
  double x0 = 0.0, y0 = 0.0;           ///< first corner (length)
  double width_x = 0.0, width_y = 0.0; ///< of a column (length)
  int nx = 0, ny = 0;

  double x(int i) const { return x0 + (i + 0.5) * width_x; }
  double y(int j) const { return y0 + (j + 0.5) * width_y; }
};

/// A box with faces across x, y, z.
struct SolidBox {
  Vector3 lower, upper; ///< (length)
};

/// Columns over a box, nearly square, `along` of them over the longer side of a box in it, whose
/// faces lie between columns: flat faces that are upright cost no accuracy then.
ColumnGrid columns_over(const SolidBox& inner, const SolidBox& outer, int along);

/// A solid on a grid: the parts of column (i, j) at i + nx j.
using SolidColumns = std::vector<ColumnParts>;

SolidColumns ellipsoid_columns(const ColumnGrid& grid, const Vector3& semiaxes);
SolidColumns sphere_columns(const ColumnGrid& grid, const SphereSet& set);
/// A closed surface, crossings counted by parity: orientation does not matter.
SolidColumns mesh_columns(const ColumnGrid& grid,
                          const std::vector<std::array<Vector3, 3>>& triangles);

/// The volume of all places that a closed surface, turned outwards, goes round neither once nor not
/// at all, because it cuts itself (length^3).
double entangled_volume(const ColumnGrid& grid,
                        const std::vector<std::array<Vector3, 3>>& triangles);

/// Volumes (length^3).
struct CommonVolume {
  double first = 0.0, second = 0.0, common = 0.0;

  double in_exactly_one() const { return first + second - 2.0 * common; }
};

CommonVolume common_volume(const ColumnGrid& grid, const SolidColumns& first,
                           const SolidColumns& second);

} // namespace ellipsoid::post
