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
      : m_points(std::move(points)), m_function(function), m_cell(cell), m_sums(m_points.size()) {
    m_bounds = {m_points.front(), m_points.front()};
    for (const Vector3& p : m_points)
      m_bounds = {bounds_of(m_bounds.lower, p, 0.0).lower, bounds_of(m_bounds.upper, p, 0.0).upper};
    m_shifts = cell.shifts(function.reach() + longest + overhang(cell, m_bounds));
    constexpr double most_cells = 64.0; // along an axis
    for (std::size_t k = 0; k < 3; ++k) {
      const double extent = component(m_bounds.upper, k) - component(m_bounds.lower, k);
      m_size[k] = std::max(function.reach(), extent / most_cells);
      m_count[k] = 1 + static_cast<std::size_t>(extent / m_size[k]);
    }
    m_cells.resize(m_count[0] * m_count[1] * m_count[2]);
    for (std::size_t n = 0; n < m_points.size(); ++n)
      m_cells[(cell_along(0, m_points[n].x) * m_count[1] + cell_along(1, m_points[n].y)) *
                  m_count[2] +
              cell_along(2, m_points[n].z)]
          .push_back(n);
  }

  void add_at(const Vector3& point, const FieldSums& source, FieldRange range) override {
    const Vector3 home = m_cell.wrapped(point);
    for (const Vector3& shift : m_shifts) {
      const Vector3 p = home + shift;
      for_near(
          bounds_of(p, p, m_function.reach()),
          [&](std::size_t n) {
            const Vector3 d = m_points[n] - p;
            return m_function.value(dot(d, d));
          },
          source, range);
    }
  }

  void add_along(const Vector3& begin, const Vector3& end, const FieldSums& source,
                 FieldRange range) override {
    const Vector3 way = end - begin, home = m_cell.wrapped(begin);
    const double length = norm(way);
    if (!(length > 1.0e-9 * m_function.width())) { // no longer than a point
      add_at(begin, source, range);
      return;
    }
    const Vector3 direction = (1.0 / length) * way;
    for (const Vector3& shift : m_shifts) {
      const Vector3 p = home + shift;
      for_near(
          bounds_of(p, p + way, m_function.reach()),
          [&](std::size_t n) {
            const Vector3 d = m_points[n] - p;
            const double foot = dot(d, direction);
            const double from_line = std::max(0.0, dot(d, d) - foot * foot);
            return m_function.along_line(from_line, -foot, length - foot) / length;
          },
          source, range);
    }
  }

  const std::vector<FieldSums>& sums() const override { return m_sums; }
  void clear() override { std::fill(m_sums.begin(), m_sums.end(), FieldSums{}); }

 private:
  std::size_t cell_along(std::size_t k, double x) const {
    const double cell = std::floor((x - component(m_bounds.lower, k)) / m_size[k]);
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(m_count[k] - 1)));
  }

  template <class Weight>
  void for_near(const Bounds& near, const Weight& weight, const FieldSums& source,
                FieldRange range) {
    if (!overlap(near, m_bounds))
      return;
    std::array<std::size_t, 3> from, to;
    for (std::size_t k = 0; k < 3; ++k) {
      from[k] = cell_along(k, component(near.lower, k));
      to[k] = cell_along(k, component(near.upper, k));
    }
    for (std::size_t i = from[0]; i <= to[0]; ++i)
      for (std::size_t j = from[1]; j <= to[1]; ++j)
        for (std::size_t k = from[2]; k <= to[2]; ++k)
          for (const std::size_t n : m_cells[(i * m_count[1] + j) * m_count[2] + k])
            if (const double w = weight(n); w > 0.0)
              add_to(m_sums[n], w, source, range);
  }

  std::vector<Vector3> m_points;
  CoarseGrainingFunction m_function;
  PeriodicCell m_cell;
  std::vector<FieldSums> m_sums;
  Bounds m_bounds;
  std::vector<Vector3> m_shifts;
  std::array<double, 3> m_size{};
  std::array<std::size_t, 3> m_count{};
  std::vector<std::vector<std::size_t>> m_cells;
};

/// The part of a segment inside a section: shares of its length.
struct Share {
  double begin = 0.0, end = 1.0;
};

class PlaneTargets : public FieldTargets {
 public:
  PlaneTargets(std::size_t axis, std::vector<double> abscissae, const std::optional<Box>& section,
               const CoarseGrainingFunction& function, const PeriodicCell& cell, double longest)
      : m_axis(axis), m_abscissae(std::move(abscissae)), m_section(section), m_function(function),
        m_cell(cell), m_sums(m_abscissae.size()) {
    const auto range = std::minmax_element(m_abscissae.begin(), m_abscissae.end());
    m_lowest = *range.first;
    m_highest = *range.second;
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
    const Vector3 home = m_cell.wrapped(begin), way = end - begin;
    for (const Vector3& shift : m_shifts) {
      const Vector3 p = home + shift;
      const Share inside = m_section ? inside_section(p, way) : Share{};
      if (!(inside.begin <= inside.end))
        continue;
      const bool is_point = norm(way) == 0.0;
      const double length = is_point ? 1.0 : inside.end - inside.begin;
      add_between(component(p + inside.begin * way, m_axis),
                  component(p + inside.end * way, m_axis), length / m_area, source, range);
    }
  }

  const std::vector<FieldSums>& sums() const override { return m_sums; }
  void clear() override { std::fill(m_sums.begin(), m_sums.end(), FieldSums{}); }

 private:
  void set_section(const Box& section, double longest) {
    Bounds bounds{{section.lower[0], section.lower[1], section.lower[2]},
                  {section.upper[0], section.upper[1], section.upper[2]}};
    m_area = 1.0;
    for (std::size_t k = 0; k < 3; ++k)
      if (k != m_axis)
        m_area *= section.upper[k] - section.lower[k];
    m_shifts = m_cell.shifts(m_function.reach() + longest + overhang(m_cell, bounds));
  }

  /// Images along the axis only: those beside it are the same planes.
  void set_cell(double longest) {
    m_area = m_cell.volume() / m_cell.thickness(m_axis);
    for (std::size_t k = 0; k < 3; ++k)
      if (k != m_axis && m_cell.is_periodic(k) && component(m_cell.edge(k), m_axis) != 0.0)
        throw InputError("the box is tilted, and planes across this axis do not repeat with it: "
                         "take a profile along z, or give --box");
    m_shifts = {Vector3{}};
    if (!m_cell.is_periodic(m_axis))
      return;
    const double low = component(m_cell.corner(), m_axis), period = m_cell.thickness(m_axis);
    const double reach =
        m_function.reach() + longest + std::max({0.0, low - m_lowest, m_highest - low - period});
    const int most = static_cast<int>(std::ceil(reach / period));
    for (int n = -most; n <= most; ++n)
      if (n != 0)
        m_shifts.push_back(double(n) * m_cell.edge(m_axis));
  }

  Share inside_section(const Vector3& begin, const Vector3& way) const {
    constexpr Share nothing{1.0, 0.0};
    Share share;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == m_axis)
        continue;
      const double from = component(begin, k), along = component(way, k);
      const double low = m_section->lower[k] - from, high = m_section->upper[k] - from;
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
    const double reach = m_function.reach();
    if (std::max(begin, end) + reach < m_lowest || std::min(begin, end) - reach > m_highest)
      return;
    // so short that the middle stands for it to 1e-9, and a difference would lose digits
    const bool is_short = std::abs(end - begin) < 1.0e-4 * m_function.width();
    for (std::size_t n = 0; n < m_abscissae.size(); ++n) {
      const double z = m_abscissae[n];
      const double mean = is_short ? m_function.over_plane(0.5 * (begin + end) - z)
                                   : m_function.between_planes(begin - z, end - z) / (end - begin);
      if (mean > 0.0)
        add_to(m_sums[n], factor * mean, source, range);
    }
  }

  std::size_t m_axis;
  std::vector<double> m_abscissae;
  std::optional<Box> m_section;
  CoarseGrainingFunction m_function;
  PeriodicCell m_cell;
  std::vector<FieldSums> m_sums;
  double m_area = 1.0, m_lowest = 0.0, m_highest = 0.0;
  std::vector<Vector3> m_shifts;
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
