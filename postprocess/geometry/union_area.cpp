// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "union_area.h"

#include "cell_grid.h"
#include "lens_batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ellipsoid::post {
namespace {

/// Edge of the region from `begin` to `end`; outside is where outward . p > offset.
struct Edge {
  Point begin, end, outward;
  double offset = 0.0;
};

std::vector<Edge> edges_of(const ConvexPolygon& region) {
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const Point begin = region[k], end = region[(k + 1) % region.size()];
    const Point along = end - begin;
    if (!(along.norm() > 0.0))
      continue;
    const Point outward = Point(along.y(), -along.x()) / along.norm();
    edges.push_back({begin, end, outward, outward.dot(begin)});
  }
  return edges;
}

/// Area of an outline that is left when the shares of hidden arcs are taken away (they are joined
/// on the way).
double free_share(const PlaneEllipse& shape, std::vector<ArcInterval>& hidden) {
  join(hidden);
  double share = shape.area();
  for (const ArcInterval& arc : hidden)
    share -= green(shape, arc);
  return share;
}

/// Part of an edge: from begin + s (end - begin) at the one s to the other.
using EdgeInterval = Interval<double>;

/// Share of the segment begin + s (end - begin), 0 <= s <= 1, inside an outline.
bool chord(const PlaneEllipse& shape, const Edge& edge, EdgeInterval& inside) {
  const auto to_unit = [&shape](const Point& p) {
    const double cosine = p.x() / shape.ux;
    return Point(cosine, (p.y() - shape.uy * cosine) / shape.vy);
  };
  const Point d = to_unit(edge.begin - shape.centre), e = to_unit(edge.end - edge.begin);
  const double middle = -d.dot(e) / e.squaredNorm();
  const double closest = (d + middle * e).squaredNorm();
  if (closest >= 1.0)
    return false;
  const double half = std::sqrt((1.0 - closest) / e.squaredNorm());
  if (2.0 * half * (edge.end - edge.begin).norm() < shortest_chord * shape.bounding_radius())
    return false;
  inside = {std::max(0.0, middle - half), std::min(1.0, middle + half)};
  return inside.end > inside.begin;
}

/// Part of an edge inside an outline.
struct EdgePart {
  std::size_t owner = 0;
  EdgeInterval inside;
};

/// The circle around an outline about its centre.
struct Circle {
  Point centre;
  double radius;
};

std::vector<Circle> circles_around(const std::vector<PlaneEllipse>& outlines) {
  std::vector<Circle> circles;
  circles.reserve(outlines.size());
  for (const PlaneEllipse& shape : outlines)
    circles.push_back({shape.centre, shape.bounding_radius()});
  return circles;
}

/// From the edge's line to a point, positive outside (length).
double beyond(const Edge& edge, const Point& point) {
  return edge.outward.dot(point) - edge.offset;
}

/// Share of one edge in the area: of all outlines together, and summed owner by owner.
void add_edge(const Edge& edge, const std::vector<PlaneEllipse>& outlines,
              const std::vector<Circle>& circles, UnionMeasures& sums) {
  std::vector<EdgePart> parts;
  std::vector<EdgeInterval> all;
  EdgePart part;
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (std::abs(beyond(edge, circles[i].centre)) <= circles[i].radius &&
        chord(outlines[i], edge, part.inside)) {
      part.owner = outlines[i].owner;
      parts.push_back(part);
      all.push_back(part.inside);
    }
  const double whole = 0.5 * cross(edge.begin, edge.end);
  const auto joined_length = [](std::vector<EdgeInterval>& intervals) {
    join(intervals);
    double length = 0.0;
    for (const EdgeInterval& interval : intervals)
      length += interval.end - interval.begin;
    return length;
  };
  sums.area += whole * joined_length(all);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const EdgePart& p, const EdgePart& q) { return p.owner < q.owner; });
  for (std::size_t k = 0; k < parts.size();) {
    std::vector<EdgeInterval> own;
    const std::size_t owner = parts[k].owner;
    for (; k < parts.size() && parts[k].owner == owner; ++k)
      own.push_back(parts[k].inside);
    sums.area_sum += whole * joined_length(own);
  }
}

/// The parts of every outline that are hidden by others or by the region's outside.
class HiddenArcs {
 public:
  HiddenArcs(const std::vector<PlaneEllipse>& outlines, const std::vector<Circle>& circles,
             const std::vector<Edge>& edges, const OutlinePairs& near)
      : outlines_(outlines), first_(outlines.size() + 1, 0) {
    found_.reserve(2 * near.size());
    for (const Edge& edge : edges)
      find_beyond(edge, circles);
    find_covered(near);
    // counted, then put in the order of their outlines
    for (const Hidden& hidden : found_)
      ++first_[hidden.outline + 1];
    for (std::size_t i = 0; i < outlines.size(); ++i)
      first_[i + 1] += first_[i];
    order_.resize(found_.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t k = 0; k < found_.size(); ++k)
      order_[next[found_[k].outline]++] = k;
  }

  /// Those of one outline: `own` by outlines of the same owner or the outside, and `all`.
  void of_outline(std::size_t i, std::vector<ArcInterval>& own,
                  std::vector<ArcInterval>& all) const {
    own.clear();
    all.clear();
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      const Hidden& hidden = found_[order_[k]];
      all.push_back(hidden.arc);
      if (hidden.is_own)
        own.push_back(hidden.arc);
    }
  }

 private:
  struct Hidden {
    std::size_t outline;
    bool is_own; ///< by an outline of the same owner, or by the outside
    ArcInterval arc;
  };

  /// An arc over the end of the turn becomes two.
  void add(std::size_t outline, bool is_own, const ArcInterval& arc) {
    if (!(arc.end < arc.begin)) {
      put(outline, is_own, arc.begin, arc.end);
      return;
    }
    put(outline, is_own, arc.begin, turn_end);
    put(outline, is_own, turn_begin, arc.end);
  }
  /// Number by number: an arc that is copied right after its numbers were stored one by one keeps
  /// the processor waiting.
  void put(std::size_t outline, bool is_own, const ArcEnd& begin, const ArcEnd& end) {
    Hidden& hidden = found_.emplace_back();
    hidden.outline = outline;
    hidden.is_own = is_own;
    hidden.arc = {{begin.turn, begin.cosine, begin.sine}, {end.turn, end.cosine, end.sine}};
  }
  /// Moves arcs to the list of those found.
  void add(std::size_t outline, bool is_own, std::vector<ArcInterval>& arcs) {
    for (const ArcInterval& arc : arcs)
      add(outline, is_own, arc);
    arcs.clear();
  }

  void find_beyond(const Edge& edge, const std::vector<Circle>& circles) {
    std::vector<ArcInterval> arcs;
    for (std::size_t i = 0; i < circles.size(); ++i)
      if (beyond(edge, circles[i].centre) + circles[i].radius > 0.0) {
        append_beyond_line(outlines_[i], edge.outward, edge.offset, arcs);
        add(i, true, arcs);
      }
  }

  void find_covered(const OutlinePairs& near) {
    for (const auto& [i, j] : near) {
      waiting_[static_cast<std::size_t>(batch_.size())] = {i, j};
      batch_.add(outlines_[i], outlines_[j]);
      if (batch_.full())
        process_waiting();
    }
    process_waiting();
  }

  void process_waiting() {
    std::vector<ArcInterval> of_i, of_j;
    batch_.solve();
    for (int k = 0; k < batch_.size(); ++k) {
      const auto [i, j] = waiting_[static_cast<std::size_t>(k)];
      const bool is_own = outlines_[i].owner == outlines_[j].owner;
      const LensBatch::Verdict verdict = batch_.verdict(k);
      if (verdict == LensBatch::Verdict::lens) {
        add(i, is_own, batch_.of_i(k));
        add(j, is_own, batch_.of_j(k));
      } else if (verdict == LensBatch::Verdict::unknown) {
        append_covered(outlines_[i], outlines_[j], of_i, of_j);
        add(i, is_own, of_i);
        add(j, is_own, of_j);
      }
    }
    batch_.clear();
  }

  LensBatch batch_;
  std::array<std::pair<std::size_t, std::size_t>, LensBatch::capacity> waiting_;
  const std::vector<PlaneEllipse>& outlines_;
  std::vector<Hidden> found_;
  std::vector<std::size_t> order_; ///< of found_: outline by outline
  std::vector<std::size_t> first_; ///< of each outline in order_
};

} // namespace

OutlinePairs near_outlines(const std::vector<PlaneEllipse>& outlines) {
  std::vector<Vector3> centres;
  std::vector<double> radii;
  for (const Circle& circle : circles_around(outlines)) {
    centres.push_back({circle.centre.x(), circle.centre.y(), 0.0});
    radii.push_back(circle.radius);
  }
  CellGrid grid(centres, radii);
  OutlinePairs pairs;
  grid.for_pairs([&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); });
  return pairs;
}

UnionMeasures union_in_region(const std::vector<PlaneEllipse>& outlines,
                              const ConvexPolygon& region) {
  return union_in_region(outlines, region, near_outlines(outlines));
}

UnionMeasures union_in_region(const std::vector<PlaneEllipse>& outlines,
                              const ConvexPolygon& region, const OutlinePairs& near) {
  UnionMeasures result;
  if (region.size() < 3)
    return result;
  const std::vector<Edge> edges = edges_of(region);
  const std::vector<Circle> circles = circles_around(outlines);
  const HiddenArcs hidden(outlines, circles, edges, near);
  std::vector<ArcInterval> own, all;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    hidden.of_outline(i, own, all);
    result.area_sum += free_share(outlines[i], own);
    result.area += free_share(outlines[i], all);
  }
  for (const Edge& edge : edges)
    add_edge(edge, outlines, circles, result);
  return result;
}

double polygon_area(const ConvexPolygon& polygon) {
  double area = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    area += 0.5 * cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  return area;
}

ConvexPolygon clipped(const ConvexPolygon& polygon, const Point& normal, double offset) {
  ConvexPolygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point p = polygon[k], q = polygon[(k + 1) % polygon.size()];
    const double beyond_p = normal.dot(p) - offset, beyond_q = normal.dot(q) - offset;
    if (beyond_p <= 0.0)
      result.push_back(p);
    if ((beyond_p < 0.0 && beyond_q > 0.0) || (beyond_p > 0.0 && beyond_q < 0.0))
      result.push_back(p + beyond_p / (beyond_p - beyond_q) * (q - p));
  }
  return result;
}

ConvexPolygon surrounding_rectangle(const std::vector<PlaneEllipse>& outlines) {
  if (outlines.empty())
    return {};
  Point lower = outlines.front().centre, upper = lower;
  for (const PlaneEllipse& shape : outlines) {
    const double reach = 2.0 * shape.bounding_radius();
    lower = lower.cwiseMin(shape.centre - Point(reach, reach));
    upper = upper.cwiseMax(shape.centre + Point(reach, reach));
  }
  return {lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}};
}

} // namespace ellipsoid::post
