// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "envelope.h"

#include "cell_grid.h"
#include "lens_batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

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
    : floor_(floor), summit_(0.0, floor) {
  if (outlines.empty())
    return;
  keep_surface_arcs(outlines);
  build();
  summit_.y() = -std::numeric_limits<double>::infinity();
  for (const PlaneEllipse& arc : arcs_)
    if (arc.top() > summit_.y())
      summit_ = {arc.centre.x() + arc.ux * arc.uy / std::hypot(arc.uy, arc.vy), arc.top()};
}

/// Lower bounds of the surface in bins of abscissas. Upper arcs are concave, so an arc is nowhere
/// in a bin that it spans lower than at the bin's two edges.
class UpperEnvelope::SurfaceBound {
 public:
  SurfaceBound(const Bins& bins, double floor) : bins_(bins), bounds_(bins.count, floor) {}

  /// Whether the outline lies wholly below other upper arcs.
  bool hides(const PlaneEllipse& shape) const {
    const auto first = bounds_.begin() + static_cast<std::ptrdiff_t>(bins_.index(shape.left()));
    const auto last = bounds_.begin() + static_cast<std::ptrdiff_t>(bins_.index(shape.right()));
    const double top = shape.top();
    return std::all_of(first, last + 1, [top](double bound) { return top < bound; });
  }

  void raise(const PlaneEllipse& shape) {
    const std::size_t last = bins_.index(shape.right());
    std::size_t k = bins_.index(shape.left());
    while (k <= last && bins_.edge(k) < shape.left())
      ++k;
    if (k > last)
      return;
    double before = shape.upper(bins_.edge(k));
    for (; k <= last && bins_.edge(k + 1) <= shape.right(); ++k) {
      const double after = shape.upper(bins_.edge(k + 1));
      bounds_[k] = std::max(bounds_[k], std::min(before, after));
      before = after;
    }
  }

 private:
  Bins bins_;
  std::vector<double> bounds_;
};

/// Leaves out outlines that lie wholly below others. The highest ones per particle's width come
/// first: most of the others are then known to be hidden without a look at their arcs.
void UpperEnvelope::keep_surface_arcs(const std::vector<PlaneEllipse>& outlines) {
  constexpr double bins_per_radius = 8.0;
  double left = outlines.front().left(), right = outlines.front().right(), widest = 0.0;
  for (const PlaneEllipse& shape : outlines) {
    left = std::min(left, shape.left());
    right = std::max(right, shape.right());
    widest = std::max(widest, shape.ux);
  }
  const auto bins_over = [&](double width) {
    const double wanted = std::ceil((right - left) / width);
    return Bins(left, right, static_cast<std::size_t>(std::clamp(wanted, 1.0, 1.0e6)));
  };
  SurfaceBound bound(bins_over(widest / bins_per_radius), floor_);
  const Bins columns = bins_over(widest);
  std::vector<const PlaneEllipse*> highest(columns.count, nullptr);
  for (const PlaneEllipse& shape : outlines) {
    const PlaneEllipse*& best = highest[columns.index(shape.centre.x())];
    if (!best || shape.centre.y() > best->centre.y())
      best = &shape;
  }
  for (const PlaneEllipse* shape : highest)
    if (shape)
      bound.raise(*shape);
  for (const PlaneEllipse& shape : outlines)
    if (!bound.hides(shape)) {
      bound.raise(shape);
      arcs_.push_back(shape);
    }
  arcs_.erase(std::remove_if(arcs_.begin(), arcs_.end(),
                             [&](const PlaneEllipse& shape) { return bound.hides(shape); }),
              arcs_.end());
}

/// Abscissas of the crossings of outlines.
class UpperEnvelope::CrossingPoints {
 public:
  CrossingPoints(const std::vector<PlaneEllipse>& arcs, std::vector<double>& abscissas)
      : arcs_(arcs), abscissas_(abscissas) {}

  void find(std::size_t i, std::size_t j) {
    waiting_[static_cast<std::size_t>(batch_.size())] = {i, j};
    batch_.add(arcs_[i], arcs_[j]);
    if (batch_.full())
      process_waiting();
  }

  /// To be called after the last pair.
  void process_waiting() {
    batch_.solve();
    for (int k = 0; k < batch_.size(); ++k) {
      const auto [i, j] = waiting_[static_cast<std::size_t>(k)];
      const PlaneEllipse& arc = arcs_[i];
      const LensBatch::Verdict verdict = batch_.verdict(k);
      if (verdict == LensBatch::Verdict::lens)
        for (const ArcEnd& end : {batch_.of_i(k).begin, batch_.of_i(k).end})
          abscissas_.push_back(arc.centre.x() + arc.ux * end.cosine);
      else if (verdict == LensBatch::Verdict::unknown)
        for (const double t : crossings(arc, arcs_[j]))
          abscissas_.push_back(arc.at(t).x());
    }
    batch_.clear();
  }

 private:
  const std::vector<PlaneEllipse>& arcs_;
  std::vector<double>& abscissas_;
  LensBatch batch_;
  std::array<std::pair<std::size_t, std::size_t>, LensBatch::capacity> waiting_;
};

/// Abscissas between which the highest arc cannot change: arc ends and crossings of arcs.
std::vector<double> UpperEnvelope::breakpoints() const {
  std::vector<Vector3> centres;
  std::vector<double> radii, result;
  for (const PlaneEllipse& arc : arcs_) {
    centres.push_back({arc.centre.x(), arc.centre.y(), 0.0});
    radii.push_back(arc.bounding_radius());
    result.push_back(arc.left());
    result.push_back(arc.right());
  }
  CellGrid grid(centres, radii);
  CrossingPoints points(arcs_, result);
  grid.for_pairs([&](std::size_t i, std::size_t j) { points.find(j, i); });
  points.process_waiting();
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void UpperEnvelope::build() {
  const std::vector<double> ends = breakpoints();
  std::vector<std::size_t> order(arcs_.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    order[k] = k;
  std::sort(order.begin(), order.end(),
            [this](std::size_t i, std::size_t j) { return arcs_[i].left() < arcs_[j].left(); });
  std::vector<std::size_t> present; // arcs that reach the interval
  std::size_t next = 0;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double middle = 0.5 * (ends[k] + ends[k + 1]);
    while (next < order.size() && arcs_[order[next]].left() <= middle)
      present.push_back(order[next++]);
    present.erase(std::remove_if(present.begin(), present.end(),
                                 [&](std::size_t i) { return arcs_[i].right() < middle; }),
                  present.end());
    std::size_t highest = no_arc;
    double height = floor_;
    for (const std::size_t i : present)
      if (const double y = arcs_[i].upper(middle); y > height) {
        height = y;
        highest = i;
      }
    if (!pieces_.empty() && pieces_.back().arc == highest)
      pieces_.back().end = ends[k + 1];
    else
      pieces_.push_back({ends[k], ends[k + 1], highest});
  }
}

double UpperEnvelope::height(double x) const {
  const auto it = std::upper_bound(pieces_.begin(), pieces_.end(), x,
                                   [](double value, const Piece& p) { return value < p.end; });
  if (it == pieces_.end() || x < it->begin || it->arc == no_arc)
    return floor_;
  return arcs_[it->arc].upper(x);
}

std::vector<double> UpperEnvelope::heights(const std::vector<double>& abscissas) const {
  std::vector<double> result(abscissas.size(), floor_);
  std::size_t k = 0;
  const auto pass = [&](double end) {
    while (k < abscissas.size() && abscissas[k] < end)
      ++k;
    return k;
  };
  for (const Piece& piece : pieces_) {
    const std::size_t begin = pass(piece.begin), end = pass(piece.end);
    if (piece.arc != no_arc)
      arcs_[piece.arc].upper(abscissas.data() + begin, end - begin, result.data() + begin);
  }
  return result;
}

double UpperEnvelope::area(double x0, double x1) const {
  double sum = 0.0;
  for (const Piece& piece : pieces_) {
    const double begin = std::max(x0, piece.begin), end = std::min(x1, piece.end);
    if (end > begin && piece.arc != no_arc)
      sum += arcs_[piece.arc].area_under_upper(begin, end) - floor_ * (end - begin);
  }
  return sum;
}

std::vector<std::size_t> UpperEnvelope::owners() const {
  std::vector<std::size_t> result;
  for (const Piece& piece : pieces_)
    if (piece.arc != no_arc)
      result.push_back(arcs_[piece.arc].owner);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace ellipsoid::post
