// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "plane_outline.h"

#include <algorithm>
#include <vector>

namespace ellipsoid::post {

/// Chords below this share of the (smaller) outline's size do not count as crossings: outlines
/// that only touch seem to cross by rounding, one of them or both. The cut-off lens has a share
/// of the area below 1e-18.
constexpr double shortest_chord = 1.0e-6;

/// A number that grows with the angle of a direction, from 0 to 4 in a whole turn, and needs no
/// trigonometric function.
double turn_of(double cosine, double sine);

/// An end of an arc: its parameter t as a direction.
struct ArcEnd {
  double turn = 0.0; ///< turn_of(cosine, sine), or 4 for the end of the whole turn
  double cosine = 1.0, sine = 0.0;
  bool operator<(const ArcEnd& other) const { return turn < other.turn; }
};
constexpr ArcEnd turn_begin{0.0, 1.0, 0.0}, turn_end{4.0, 1.0, 0.0};

template <class End> struct Interval { End begin, end; };
/// Part of an outline. One that runs over the end of the turn has end < begin.
using ArcInterval = Interval<ArcEnd>;

/// The arc's share of the outline's area by Green's theorem: 1/2 of the line integral of
/// x dy - y dx (length^2).
/// @param[in] arc begin <= end
double green(const PlaneEllipse& shape, const ArcInterval& arc);

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

/// Sorts and joins overlapping intervals, begin <= end in each.
template <class End> void join(std::vector<Interval<End>>& intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval<End>& a, const Interval<End>& b) { return a.begin < b.begin; });
  std::size_t kept = 0;
  for (const Interval<End>& next : intervals) {
    if (kept > 0 && !(intervals[kept - 1].end < next.begin))
      intervals[kept - 1].end = std::max(intervals[kept - 1].end, next.end);
    else
      intervals[kept++] = next;
  }
  intervals.resize(kept);
}

} // namespace ellipsoid::post
