// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "plane_outline.h"

#include <vector>

namespace ellipsoid::post {

/// Chords below this share of the (smaller) outline's size do not count as crossings: outlines
/// that only touch seem to cross by rounding, one of them or both. The cut-off lens has a share
/// of the area below 1e-18.
constexpr double shortest_chord = 1.0e-6;

/// Part of an outline's parameter range, begin < end, within [0, 2 pi].
struct ArcInterval {
  double begin = 0.0, end = 0.0;
};

/// Parameters t in [0, 2 pi), ascending, at which outline i crosses outline j (at most four).
/// Touching without crossing gives none. The roots are found by subdivision with a bound of the
/// second derivative, so that none is missed but pairs closer than 1e-9 rad.
std::vector<double> crossings(const PlaneEllipse& i, const PlaneEllipse& j);

/// Appends the parts of each of two outlines that lie inside the other. Where both are the same
/// curve, i is left free.
void append_covered(const PlaneEllipse& i, const PlaneEllipse& j, std::vector<ArcInterval>& of_i,
                    std::vector<ArcInterval>& of_j);

/// Appends the parts of outline i with normal . p > offset (outside of a half-plane).
void append_beyond_line(const PlaneEllipse& i, const Point& normal, double offset,
                        std::vector<ArcInterval>& of_i);

/// Sorts and joins overlapping intervals.
void join(std::vector<ArcInterval>& intervals);

} // namespace ellipsoid::post
