// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "outline_crossings.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

constexpr double two_pi = 2.0 * 3.141592653589793238462643;

/// Roots closer together than this (rad) are not told apart: the lens between them has a
/// share of about 1e-27 of the ellipse's area.
constexpr double closest_roots = 1.0e-9;

/// Coefficients below this share of 1 mean that both outlines are the same curve.
constexpr double same_outline = 1.0e-12;

/// f(t) = k + c1 cos t + s1 sin t + c2 cos 2t + s2 sin 2t.
struct TrigonometricPolynomial {
  double k = 0.0, c1 = 0.0, s1 = 0.0, c2 = 0.0, s2 = 0.0;

  /// Value and first derivative.
  struct Jet {
    double value, slope;
  };
  Jet at(double t) const {
    const double c = std::cos(t), s = std::sin(t);
    const double cc = c * c - s * s, ss = 2.0 * s * c;
    return {k + c1 * c + s1 * s + c2 * cc + s2 * ss, s1 * c - c1 * s + 2.0 * (s2 * cc - c2 * ss)};
  }
  double value(double t) const { return at(t).value; }
  double largest_curvature() const { return std::hypot(c1, s1) + 4.0 * std::hypot(c2, s2); }
  double size() const {
    return std::max({std::abs(k), std::abs(c1), std::abs(s1), std::abs(c2), std::abs(s2)});
  }
};

/// Level of j along outline i: negative where i lies inside j.
TrigonometricPolynomial level_along(const PlaneEllipse& i, const PlaneEllipse& j) {
  // maps a vector of the plane into the unit circle of j
  const auto to_unit = [&j](double x, double y) {
    const double cosine = x / j.ux;
    return Point(cosine, (y - j.uy * cosine) / j.vy);
  };
  const Point d = to_unit(i.centre.x() - j.centre.x(), i.centre.y() - j.centre.y());
  const Point p = to_unit(i.ux, i.uy), q = to_unit(0.0, i.vy);
  // |d + p cos t + q sin t|^2 - 1
  return {d.dot(d) + 0.5 * (p.dot(p) + q.dot(q)) - 1.0, 2.0 * d.dot(p), 2.0 * d.dot(q),
          0.5 * (p.dot(p) - q.dot(q)), p.dot(q)};
}

/// Root in an interval in which f changes its sign and is monotone: Newton's method, kept within
/// the shrinking bracket.
double bracketed_root(const TrigonometricPolynomial& f, double begin, double end, bool rises) {
  double t = 0.5 * (begin + end);
  for (int step = 0; step < 60; ++step) {
    const auto jet = f.at(t);
    ((jet.value < 0.0) == rises ? begin : end) = t;
    const double newton = t - jet.value / jet.slope;
    const double next = newton > begin && newton < end ? newton : 0.5 * (begin + end);
    if (std::abs(next - t) < 1e-16 * two_pi)
      return next;
    t = next;
  }
  return t;
}

/// An end of an interval with the value there.
struct Sample {
  double t, value;
};

void collect_roots(const TrigonometricPolynomial& f, double bound, const Sample& begin,
                   const Sample& end, std::vector<double>& roots) {
  const double width = end.t - begin.t;
  const bool sign_changes = (begin.value < 0.0) != (end.value < 0.0);
  if (!sign_changes &&
      std::min(std::abs(begin.value), std::abs(end.value)) > bound * width * width / 8.0)
    return; // f stays within bound w^2 / 8 of its chord
  const double middle = 0.5 * (begin.t + end.t);
  const auto jet = f.at(middle);
  const bool is_monotone = std::abs(jet.slope) > 0.5 * bound * width;
  if (sign_changes && (is_monotone || width < closest_roots)) {
    roots.push_back(bracketed_root(f, begin.t, end.t, begin.value < 0.0));
    return;
  }
  if (is_monotone || width < closest_roots)
    return;
  collect_roots(f, bound, begin, {middle, jet.value}, roots);
  collect_roots(f, bound, {middle, jet.value}, end, roots);
}

std::vector<double> roots_of(const TrigonometricPolynomial& f) {
  std::vector<double> roots;
  if (std::abs(f.k) > std::hypot(f.c1, f.s1) + std::hypot(f.c2, f.s2))
    return roots; // the waves cannot reach zero
  constexpr int parts = 8;
  const double bound = f.largest_curvature();
  Sample begin{0.0, f.value(0.0)};
  for (int part = 1; part <= parts; ++part) {
    const double t = two_pi * part / parts;
    const Sample end{t, f.value(t)};
    collect_roots(f, bound, begin, end, roots);
    begin = end;
  }
  return roots;
}

bool are_apart(const PlaneEllipse& i, const PlaneEllipse& j) {
  const double reach = i.bounding_radius() + j.bounding_radius();
  return (i.centre - j.centre).squaredNorm() > reach * reach;
}

/// Intervals between neighbouring roots in which f < 0; the last one may reach beyond 2 pi.
std::vector<ArcInterval> negative_intervals(const TrigonometricPolynomial& f) {
  const std::vector<double> roots = roots_of(f);
  std::vector<ArcInterval> result;
  if (roots.empty() && f.value(0.0) < 0.0 && f.value(1.0) < 0.0)
    result.push_back({0.0, two_pi});
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const double end = k + 1 < roots.size() ? roots[k + 1] : roots[0] + two_pi;
    if (end > roots[k] && f.value(0.5 * (roots[k] + end)) < 0.0)
      result.push_back({roots[k], end});
  }
  return result;
}

/// Cuts intervals at 2 pi.
std::vector<ArcInterval> within_one_turn(const std::vector<ArcInterval>& intervals) {
  std::vector<ArcInterval> result;
  for (const ArcInterval& interval : intervals) {
    result.push_back({interval.begin, std::min(interval.end, two_pi)});
    if (interval.end > two_pi)
      result.push_back({0.0, interval.end - two_pi});
  }
  return result;
}

/// Takes away lenses with a chord below `limit`.
void drop_touches(std::vector<ArcInterval>& intervals, const PlaneEllipse& i, double limit) {
  intervals.erase(std::remove_if(intervals.begin(), intervals.end(),
                                 [&](const ArcInterval& arc) {
                                   return arc.end - arc.begin < 0.5 &&
                                          (i.at(arc.end) - i.at(arc.begin)).norm() < limit;
                                 }),
                  intervals.end());
}

} // namespace

std::vector<double> crossings(const PlaneEllipse& i, const PlaneEllipse& j) {
  if (are_apart(i, j))
    return {};
  const TrigonometricPolynomial f = level_along(i, j);
  return f.size() < same_outline ? std::vector<double>{} : roots_of(f);
}

std::vector<ArcInterval> covered_arcs(const PlaneEllipse& i, const PlaneEllipse& j, bool j_wins) {
  if (are_apart(i, j))
    return {};
  const TrigonometricPolynomial f = level_along(i, j);
  if (f.size() < same_outline)
    return j_wins ? std::vector<ArcInterval>{{0.0, two_pi}} : std::vector<ArcInterval>{};
  std::vector<ArcInterval> covered = negative_intervals(f);
  drop_touches(covered, i, shortest_chord * std::min(i.bounding_radius(), j.bounding_radius()));
  return within_one_turn(covered);
}

std::vector<ArcInterval> arcs_beyond_line(const PlaneEllipse& i, const Point& normal,
                                          double offset) {
  TrigonometricPolynomial f; // offset - normal . p(t): negative beyond
  f.k = offset - normal.dot(i.centre);
  f.c1 = -(normal.x() * i.ux + normal.y() * i.uy);
  f.s1 = -normal.y() * i.vy;
  if (std::abs(f.k) >= std::hypot(f.c1, f.s1))
    return f.k < 0.0 ? std::vector<ArcInterval>{{0.0, two_pi}} : std::vector<ArcInterval>{};
  std::vector<ArcInterval> beyond = negative_intervals(f);
  drop_touches(beyond, i, shortest_chord * i.bounding_radius());
  return within_one_turn(beyond);
}

void join(std::vector<ArcInterval>& intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const ArcInterval& a, const ArcInterval& b) { return a.begin < b.begin; });
  std::size_t kept = 0;
  for (const ArcInterval& next : intervals) {
    if (kept > 0 && next.begin <= intervals[kept - 1].end)
      intervals[kept - 1].end = std::max(intervals[kept - 1].end, next.end);
    else
      intervals[kept++] = next;
  }
  intervals.resize(kept);
}

} // namespace ellipsoid::post
