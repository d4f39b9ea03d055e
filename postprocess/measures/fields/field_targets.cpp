// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "field_targets.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ellipsoid::post {
namespace {

double component(const Vector3& v, std::size_t k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

struct Bounds {
  Vector3 lower, upper;
};

Bounds bounds_of(const Vector3& p, const Vector3& q, double margin) {
  return {{std::min(p.x, q.x) - margin, std::min(p.y, q.y) - margin, std::min(p.z, q.z) - margin},
          {std::max(p.x, q.x) + margin, std::max(p.y, q.y) + margin, std::max(p.z, q.z) + margin}};
}

bool overlap(const Bounds& p, const Bounds& q) {
  return p.lower.x <= q.upper.x && q.lower.x <= p.upper.x && p.lower.y <= q.upper.y &&
         q.lower.y <= p.upper.y && p.lower.z <= q.upper.z && q.lower.z <= p.upper.z;
}

/// How far bounds stick out of a cell, in planes of the cell (length).
double overhang(const PeriodicCell& cell, const Bounds& bounds) {
  double farthest = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vector3 f = cell.fractions({corner & 1 ? bounds.upper.x : bounds.lower.x,
                                      corner & 2 ? bounds.upper.y : bounds.lower.y,
                                      corner & 4 ? bounds.upper.z : bounds.lower.z});
    for (std::size_t k = 0; k < 3; ++k)
      if (cell.is_periodic(k))
        farthest = std::max(farthest,
                            std::max(-component(f, k), component(f, k) - 1.0) * cell.thickness(k));
  }
  return farthest;
}

void add_to(FieldSums& sums, double weight, const FieldSums& source, FieldRange range) {
  for (std::size_t k = range.first; k < range.last; ++k)
    sums[k] += weight * source[k];
}

/// Points in cubic cells of about the function's reach.
class PointTargets : public FieldTargets {
 public:
  PointTargets(std::vector<Vector3> points, const CoarseGrainingFunction& function,
               const PeriodicCell& cell, double longest)
      : points_(std::move(points)), function_(function), cell_(cell), sums_(points_.size()) {
    bounds_ = {points_.front(), points_.front()};
    for (const Vector3& p : points_)
      bounds_ = {bounds_of(bounds_.lower, p, 0.0).lower, bounds_of(bounds_.upper, p, 0.0).upper};
    shifts_ = cell.shifts(function.reach() + longest + overhang(cell, bounds_));
    constexpr double most_cells = 64.0; // along an axis
    for (std::size_t k = 0; k < 3; ++k) {
      const double extent = component(bounds_.upper, k) - component(bounds_.lower, k);
      size_[k] = std::max(function.reach(), extent / most_cells);
      count_[k] = 1 + static_cast<std::size_t>(extent / size_[k]);
    }
    cells_.resize(count_[0] * count_[1] * count_[2]);
    for (std::size_t n = 0; n < points_.size(); ++n)
      cells_[(cell_along(0, points_[n].x) * count_[1] + cell_along(1, points_[n].y)) * count_[2] +
             cell_along(2, points_[n].z)]
          .push_back(n);
  }

  void add_at(const Vector3& point, const FieldSums& source, FieldRange range) override {
    const Vector3 home = cell_.wrapped(point);
    for (const Vector3& shift : shifts_) {
      const Vector3 p = home + shift;
      for_near(
          bounds_of(p, p, function_.reach()),
          [&](std::size_t n) {
            const Vector3 d = points_[n] - p;
            return function_.value(dot(d, d));
          },
          source, range);
    }
  }

  void add_along(const Vector3& begin, const Vector3& end, const FieldSums& source,
                 FieldRange range) override {
    const Vector3 way = end - begin, home = cell_.wrapped(begin);
    const double length = norm(way);
    if (!(length > 1.0e-9 * function_.width())) { // practically a point
      add_at(begin, source, range);
      return;
    }
    const Vector3 direction = (1.0 / length) * way;
    for (const Vector3& shift : shifts_) {
      const Vector3 p = home + shift;
      for_near(
          bounds_of(p, p + way, function_.reach()),
          [&](std::size_t n) {
            const Vector3 d = points_[n] - p;
            const double foot = dot(d, direction);
            const double from_line = std::max(0.0, dot(d, d) - foot * foot);
            return function_.along_line(from_line, -foot, length - foot) / length;
          },
          source, range);
    }
  }

  const std::vector<FieldSums>& sums() const override { return sums_; }
  void clear() override { std::fill(sums_.begin(), sums_.end(), FieldSums{}); }

 private:
  std::size_t cell_along(std::size_t k, double x) const {
    const double cell = std::floor((x - component(bounds_.lower, k)) / size_[k]);
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count_[k] - 1)));
  }

  template <class Weight>
  void for_near(const Bounds& near, const Weight& weight, const FieldSums& source,
                FieldRange range) {
    if (!overlap(near, bounds_))
      return;
    std::array<std::size_t, 3> from, to;
    for (std::size_t k = 0; k < 3; ++k) {
      from[k] = cell_along(k, component(near.lower, k));
      to[k] = cell_along(k, component(near.upper, k));
    }
    for (std::size_t i = from[0]; i <= to[0]; ++i)
      for (std::size_t j = from[1]; j <= to[1]; ++j)
        for (std::size_t k = from[2]; k <= to[2]; ++k)
          for (const std::size_t n : cells_[(i * count_[1] + j) * count_[2] + k])
            if (const double w = weight(n); w > 0.0)
              add_to(sums_[n], w, source, range);
  }

  std::vector<Vector3> points_;
  CoarseGrainingFunction function_;
  PeriodicCell cell_;
  std::vector<FieldSums> sums_;
  Bounds bounds_;
  std::vector<Vector3> shifts_;
  std::array<double, 3> size_{};
  std::array<std::size_t, 3> count_{};
  std::vector<std::vector<std::size_t>> cells_;
};

/// The part of a segment inside a section: shares of its length.
struct Share {
  double begin = 0.0, end = 1.0;
};

class PlaneTargets : public FieldTargets {
 public:
  PlaneTargets(std::size_t axis, std::vector<double> abscissae, const std::optional<Box>& section,
               const CoarseGrainingFunction& function, const PeriodicCell& cell, double longest)
      : axis_(axis), abscissae_(std::move(abscissae)), section_(section), function_(function),
        cell_(cell), sums_(abscissae_.size()) {
    const auto range = std::minmax_element(abscissae_.begin(), abscissae_.end());
    lowest_ = *range.first;
    highest_ = *range.second;
    if (section)
      set_section(*section, longest);
    else
      set_cell(longest);
  }

  void add_at(const Vector3& point, const FieldSums& source, FieldRange range) override {
    add_along(point, point, source, range);
  }

  void add_along(const Vector3& begin, const Vector3& end, const FieldSums& source,
                 FieldRange range) override {
    const Vector3 home = cell_.wrapped(begin), way = end - begin;
    for (const Vector3& shift : shifts_) {
      const Vector3 p = home + shift;
      const Share inside = section_ ? inside_section(p, way) : Share{};
      if (!(inside.begin <= inside.end))
        continue;
      const bool is_point = norm(way) == 0.0;
      const double length = is_point ? 1.0 : inside.end - inside.begin;
      add_between(component(p + inside.begin * way, axis_), component(p + inside.end * way, axis_),
                  length / area_, source, range);
    }
  }

  const std::vector<FieldSums>& sums() const override { return sums_; }
  void clear() override { std::fill(sums_.begin(), sums_.end(), FieldSums{}); }

 private:
  void set_section(const Box& section, double longest) {
    Bounds bounds{{section.lower[0], section.lower[1], section.lower[2]},
                  {section.upper[0], section.upper[1], section.upper[2]}};
    area_ = 1.0;
    for (std::size_t k = 0; k < 3; ++k)
      if (k != axis_)
        area_ *= section.upper[k] - section.lower[k];
    shifts_ = cell_.shifts(function_.reach() + longest + overhang(cell_, bounds));
  }

  /// Images along the axis only: those beside it are the same planes.
  void set_cell(double longest) {
    area_ = cell_.volume() / cell_.thickness(axis_);
    for (std::size_t k = 0; k < 3; ++k)
      if (k != axis_ && component(cell_.edge(k), axis_) != 0.0)
        throw InputError("the box is tilted, and its sections across this axis are not all alike: "
                         "take a profile along z, or give --box");
    shifts_ = {Vector3{}};
    if (!cell_.is_periodic(axis_))
      return;
    const double low = component(cell_.corner(), axis_), period = cell_.thickness(axis_);
    const double reach =
        function_.reach() + longest + std::max({0.0, low - lowest_, highest_ - low - period});
    const int most = static_cast<int>(std::ceil(reach / period));
    for (int n = -most; n <= most; ++n)
      if (n != 0)
        shifts_.push_back(double(n) * cell_.edge(axis_));
  }

  Share inside_section(const Vector3& begin, const Vector3& way) const {
    constexpr Share nothing{1.0, 0.0};
    Share share;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == axis_)
        continue;
      const double from = component(begin, k), along = component(way, k);
      const double low = section_->lower[k] - from, high = section_->upper[k] - from;
      if (along == 0.0) {
        if (low > 0.0 || high <= 0.0)
          return nothing;
        continue;
      }
      share.begin = std::max(share.begin, std::min(low / along, high / along));
      share.end = std::min(share.end, std::max(low / along, high / along));
    }
    return share;
  }

  void add_between(double begin, double end, double factor, const FieldSums& source,
                   FieldRange range) {
    const double reach = function_.reach();
    if (std::max(begin, end) + reach < lowest_ || std::min(begin, end) - reach > highest_)
      return;
    // so short that the middle stands for it to 1e-9, and a difference would lose digits
    const bool is_short = std::abs(end - begin) < 1.0e-4 * function_.width();
    for (std::size_t n = 0; n < abscissae_.size(); ++n) {
      const double z = abscissae_[n];
      const double mean = is_short ? function_.over_plane(0.5 * (begin + end) - z)
                                   : function_.between_planes(begin - z, end - z) / (end - begin);
      if (mean > 0.0)
        add_to(sums_[n], factor * mean, source, range);
    }
  }

  std::size_t axis_;
  std::vector<double> abscissae_;
  std::optional<Box> section_;
  CoarseGrainingFunction function_;
  PeriodicCell cell_;
  std::vector<FieldSums> sums_;
  double area_ = 1.0, lowest_ = 0.0, highest_ = 0.0;
  std::vector<Vector3> shifts_;
};

} // namespace

std::unique_ptr<FieldTargets> point_targets(std::vector<Vector3> points,
                                            const CoarseGrainingFunction& function,
                                            const PeriodicCell& cell, double longest) {
  if (points.empty())
    throw InputError("there are no points at which fields are wanted");
  return std::make_unique<PointTargets>(std::move(points), function, cell, longest);
}

std::unique_ptr<FieldTargets> plane_targets(std::size_t axis, std::vector<double> abscissae,
                                            const std::optional<Box>& section,
                                            const CoarseGrainingFunction& function,
                                            const PeriodicCell& cell, double longest) {
  if (abscissae.empty())
    throw InputError("there are no planes at which fields are wanted");
  return std::make_unique<PlaneTargets>(axis, std::move(abscissae), section, function, cell,
                                        longest);
}

} // namespace ellipsoid::post
