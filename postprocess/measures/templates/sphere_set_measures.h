// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A set of spheres beside the solid that it stands for: an ellipsoid, or what a mesh encloses.
#pragma once

#include "solid_columns.h"
#include "union_surface.h"

#include <functional>
#include <vector>

namespace ellipsoid::post {

/// What sets of spheres are compared with.
struct Solid {
  double volume = 0.0, surface = 0.0; ///< (length^3, length^2)
  Vector3 centre;                     ///< of mass, density constant (length)
  SymmetricMatrix3 inertia;           ///< about it, density 1 (length^5)
  SolidBox box;
  std::vector<SurfacePoint> points; ///< of its surface
  std::function<SolidColumns(const ColumnGrid&)> columns;
  std::function<double(const Vector3&)> distance; ///< from its surface, >= 0 (length)
  std::function<Vector3(const Vector3&)> onto;    ///< a point of its surface near the one given
};

/// About the origin, semi-axes along x, y, z.
Solid solid_ellipsoid(const Vector3& semiaxes);

/// Distances between two outlines (length). Means and root-mean-squares are sums over some ten
/// thousand points; from the largest of these the largest distances are searched, to 1e-4 of
/// themselves.
struct OutlineDistances {
  double largest_to_spheres = 0.0, mean_to_spheres = 0.0; ///< from points of the solid's surface
  double largest_to_solid = 0.0, mean_to_solid = 0.0;     ///< from points of the spheres'
  double rms_to_spheres = 0.0, rms_to_solid = 0.0;        ///< root-mean-squares
};

/// Columns over the longer side with which volumes are known to 1e-4 of the solid's.
constexpr int comparison_columns = 400;

/// The volume in exactly one of the two as a share of the solid's.
double share_in_exactly_one(const SphereSet& set, const Solid& solid, int columns_along);

OutlineDistances outline_distances(const SphereSet& set, const Solid& solid);

/// Of the section through the centre that holds the two larger semi-axes: Markauskas et al. 2010.
struct SectionFactors {
  double area = 0.0;      ///< eq. (26)
  double perimeter = 0.0; ///< eq. (27)
};

/// A set about the origin beside the ellipsoid, semi-axes along x, y, z.
SectionFactors section_factors(const SphereSet& set, const Vector3& semiaxes);

} // namespace ellipsoid::post
