// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "plane_outline.h"

#include <utility>
#include <vector>

namespace ellipsoid::post {

/// A convex polygon, corners counter-clockwise.
using ConvexPolygon = std::vector<Point>;

struct UnionMeasures {
  double area = 0.0;     ///< of the union (length^2)
  double area_sum = 0.0; ///< added owner by owner, each the union of its own outlines (length^2)
};

/// Pairs of outlines that may overlap, by their indices, the smaller one first.
using OutlinePairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Those whose surrounding circles overlap.
OutlinePairs near_outlines(const std::vector<PlaneEllipse>& outlines);

/// Area of the union of outlines inside a convex region, each point counted once.
///
/// Exact to rounding: by Green's theorem over the arcs of the outlines that lie in no other
/// outline and inside the region, and over the parts of the region's edges inside an outline.
UnionMeasures union_in_region(const std::vector<PlaneEllipse>& outlines,
                              const ConvexPolygon& region);
/// @param[in] near every pair that overlaps, and others
UnionMeasures union_in_region(const std::vector<PlaneEllipse>& outlines,
                              const ConvexPolygon& region, const OutlinePairs& near);

/// Area of a simple polygon, positive counter-clockwise (length^2).
double polygon_area(const ConvexPolygon& polygon);

/// Part of a convex polygon with normal . p <= offset.
ConvexPolygon clipped(const ConvexPolygon& polygon, const Point& normal, double offset);

/// A rectangle that holds all outlines with room to spare.
ConvexPolygon surrounding_rectangle(const std::vector<PlaneEllipse>& outlines);

} // namespace ellipsoid::post
