// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "envelope.h"

#include "cell_grid.h"
#include "outline_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ellipsoid::post {
namespace {

/// Bins of equal width over an interval of abscissas.
struct Bins {
  double left = 0.0, width = 1.0;
  std::size_t count = 1;

  Bins(double begin, double end, std::size_t number)
      : left(begin), width((end - begin) / static_cast<double>(number)), count(number) {}
  std::size_t index(double x) const {
    const double k = std::floor((x - left) / width);
    return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(count - 1)));
  }
  double edge(std::size_t k) const { return left + static_cast<double>(k) * width; }
};

} // namespace

UpperEnvelope::UpperEnvelope(const std::vector<PlaneEllipse>& outlines, double floor)
    : m_floor(floor), m_summit(0.0, floor) {
  if (outlines.empty())
    return;
  keep_surface_arcs(outlines);
  build();
  m_summit.y() = -std::numeric_limits<double>::infinity();
  for (const PlaneEllipse& arc : m_arcs)
    if (arc.top() > m_summit.y())
      m_summit = {arc.centre.x() + arc.ux * arc.uy / std::hypot(arc.uy, arc.vy), arc.top()};
}

/// Leaves out outlines that lie wholly below others: in each of their bins another upper arc,
/// which spans the bin, stays above their top. Upper arcs are concave, so an arc is nowhere in a
/// bin lower than at the bin's two edges.
void UpperEnvelope::keep_surface_arcs(const std::vector<PlaneEllipse>& outlines) {
  double left = outlines.front().left(), right = outlines.front().right(), widest = 0.0;
  for (const PlaneEllipse& shape : outlines) {
    left = std::min(left, shape.left());
    right = std::max(right, shape.right());
    widest = std::max(widest, shape.ux);
  }
  const double wanted = std::ceil(8.0 * (right - left) / widest);
  const Bins bins(left, right, static_cast<std::size_t>(std::clamp(wanted, 1.0, 1.0e6)));
  std::vector<double> lower_bound(bins.count, m_floor);
  for (const PlaneEllipse& shape : outlines)
    for (std::size_t k = bins.index(shape.left()); k <= bins.index(shape.right()); ++k)
      if (bins.edge(k) >= shape.left() && bins.edge(k + 1) <= shape.right())
        lower_bound[k] = std::max(
            lower_bound[k], std::min(shape.upper(bins.edge(k)), shape.upper(bins.edge(k + 1))));
  for (const PlaneEllipse& shape : outlines) {
    const std::size_t first = bins.index(shape.left()), last = bins.index(shape.right());
    const bool is_hidden = std::all_of(lower_bound.begin() + static_cast<std::ptrdiff_t>(first),
                                       lower_bound.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                                       [&](double bound) { return shape.top() < bound; });
    if (!is_hidden)
      m_arcs.push_back(shape);
  }
}

/// Abscissas between which the highest arc cannot change: arc ends and crossings of arcs.
std::vector<double> UpperEnvelope::breakpoints() const {
  std::vector<Vector3> centres;
  std::vector<double> radii, result;
  for (const PlaneEllipse& arc : m_arcs) {
    centres.push_back({arc.centre.x(), arc.centre.y(), 0.0});
    radii.push_back(arc.bounding_radius());
    result.push_back(arc.left());
    result.push_back(arc.right());
  }
  CellGrid grid(centres, radii);
  for (std::size_t i = 0; i < m_arcs.size(); ++i)
    grid.for_later_neighbours(i, [&](std::size_t j) {
      for (const double t : crossings(m_arcs[j], m_arcs[i]))
        result.push_back(m_arcs[j].at(t).x());
    });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void UpperEnvelope::build() {
  const std::vector<double> ends = breakpoints();
  std::vector<std::size_t> order(m_arcs.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    order[k] = k;
  std::sort(order.begin(), order.end(),
            [this](std::size_t i, std::size_t j) { return m_arcs[i].left() < m_arcs[j].left(); });
  std::vector<std::size_t> present; // arcs that reach the interval
  std::size_t next = 0;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double middle = 0.5 * (ends[k] + ends[k + 1]);
    while (next < order.size() && m_arcs[order[next]].left() <= middle)
      present.push_back(order[next++]);
    present.erase(std::remove_if(present.begin(), present.end(),
                                 [&](std::size_t i) { return m_arcs[i].right() < middle; }),
                  present.end());
    std::size_t highest = no_arc;
    double height = m_floor;
    for (const std::size_t i : present)
      if (const double y = m_arcs[i].upper(middle); y > height) {
        height = y;
        highest = i;
      }
    if (!m_pieces.empty() && m_pieces.back().arc == highest)
      m_pieces.back().end = ends[k + 1];
    else
      m_pieces.push_back({ends[k], ends[k + 1], highest});
  }
}

double UpperEnvelope::height(double x) const {
  const auto it = std::upper_bound(m_pieces.begin(), m_pieces.end(), x,
                                   [](double value, const Piece& p) { return value < p.end; });
  if (it == m_pieces.end() || x < it->begin || it->arc == no_arc)
    return m_floor;
  return m_arcs[it->arc].upper(x);
}

double UpperEnvelope::area(double x0, double x1) const {
  double sum = 0.0;
  for (const Piece& piece : m_pieces) {
    const double begin = std::max(x0, piece.begin), end = std::min(x1, piece.end);
    if (end > begin && piece.arc != no_arc)
      sum += m_arcs[piece.arc].area_under_upper(begin, end) - m_floor * (end - begin);
  }
  return sum;
}

std::vector<std::size_t> UpperEnvelope::owners() const {
  std::vector<std::size_t> result;
  for (const Piece& piece : m_pieces)
    if (piece.arc != no_arc)
      result.push_back(m_arcs[piece.arc].owner);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace ellipsoid::post
