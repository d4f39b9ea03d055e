// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "outline_crossings.h"

#include <algorithm>
#include <array>
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
  Jet at(double t) const { return at(std::cos(t), std::sin(t)); }
  Jet at(double c, double s) const {
    const double cc = c * c - s * s, ss = 2.0 * s * c;
    return {k + c1 * c + s1 * s + c2 * cc + s2 * ss, s1 * c - c1 * s + 2.0 * (s2 * cc - c2 * ss)};
  }
  double value(double t) const { return at(t).value; }
  double curvature(double c, double s) const {
    return -(c1 * c + s1 * s) - 4.0 * (c2 * (c * c - s * s) + 2.0 * s2 * s * c);
  }
  double first_wave() const { return std::sqrt(c1 * c1 + s1 * s1); }
  double second_wave() const { return std::sqrt(c2 * c2 + s2 * s2); }
  double largest_curvature() const { return first_wave() + 4.0 * second_wave(); }
  double size() const {
    return std::max({std::abs(k), std::abs(c1), std::abs(s1), std::abs(c2), std::abs(s2)});
  }
};

/// Outline i after the mapping that makes j the unit circle about 0: d + p cos t + q sin t.
struct InUnitCircle {
  Point d, p, q;
};

InUnitCircle in_unit_circle(const PlaneEllipse& i, const PlaneEllipse& j) {
  const auto to_unit = [&j](double x, double y) {
    const double cosine = x / j.ux;
    return Point(cosine, (y - j.uy * cosine) / j.vy);
  };
  return {to_unit(i.centre.x() - j.centre.x(), i.centre.y() - j.centre.y()), to_unit(i.ux, i.uy),
          to_unit(0.0, i.vy)};
}

/// Level of j along outline i: negative where i lies inside j.
TrigonometricPolynomial level_along(const PlaneEllipse& i, const PlaneEllipse& j) {
  const auto [d, p, q] = in_unit_circle(i, j);
  // |d + p cos t + q sin t|^2 - 1
  return {d.dot(d) + 0.5 * (p.dot(p) + q.dot(q)) - 1.0, 2.0 * d.dot(p), 2.0 * d.dot(q),
          0.5 * (p.dot(p) - q.dot(q)), p.dot(q)};
}

/// An end of an interval with its cosine and sine and the value there.
struct Sample {
  double t, cosine, sine, value;
};

/// Where f changes its sign.
struct Root {
  double t, cosine, sine;
  bool rises; ///< f is negative before and positive after it
};

/// Turns the direction (cosine, sine) by a small angle: series up to the eighth order, and their
/// rounding for angles below 0.05.
void turn(double angle, double& cosine, double& sine) {
  const double squared = angle * angle;
  const double c =
      1.0 -
      squared / 2.0 * (1.0 - squared / 12.0 * (1.0 - squared / 30.0 * (1.0 - squared / 56.0)));
  const double s = angle * (1.0 - squared / 6.0 * (1.0 - squared / 20.0 * (1.0 - squared / 42.0)));
  const double turned = cosine * c - sine * s;
  sine = sine * c + cosine * s;
  cosine = turned;
}

/// Root in an interval in which f changes its sign and is monotone: the parabola of value, slope
/// and curvature is solved again and again, kept within the shrinking bracket. A step's error is
/// about bound step^3 / (3 slope).
Root bracketed_root(const TrigonometricPolynomial& f, double bound, double begin, double end,
                    const Sample& start, bool rises) {
  constexpr double small_turn = 0.05, largest_error = 1.0e-17;
  Root root{start.t, start.cosine, start.sine, rises};
  const double last_step = std::max(1e-10 * (end - begin), 1e-16 * two_pi);
  for (int step = 0; step < 60; ++step) {
    const auto jet = f.at(root.cosine, root.sine);
    ((jet.value < 0.0) == rises ? begin : end) = root.t;
    const double curvature = f.curvature(root.cosine, root.sine);
    const double squared = jet.slope * jet.slope - 2.0 * jet.value * curvature;
    const double steepness = std::sqrt(std::max(0.0, squared));
    const double parabola =
        root.t - 2.0 * jet.value / (jet.slope + std::copysign(steepness, jet.slope));
    const double next = parabola >= begin && parabola <= end ? parabola : 0.5 * (begin + end);
    const double change = next - root.t, size = std::abs(change);
    root.t = next;
    if (size < small_turn) {
      turn(change, root.cosine, root.sine);
    } else {
      root.cosine = std::cos(next);
      root.sine = std::sin(next);
    }
    if (size <= last_step || (next == parabola && squared > 0.0 &&
                              bound * size * size * size <= largest_error * steepness))
      break;
  }
  return root;
}

/// The intervals of the subdivision: eighths of the turn, halved again and again.
struct Halvings {
  static constexpr int first_parts = 8, most = 40;
  std::array<double, first_parts + 1> cosines, sines;
  /// 1 / (2 cos(w / 2)) for intervals of width w: cos a + cos b = 2 cos(w / 2) cos(middle)
  std::array<double, most> to_middle;

  Halvings() {
    for (std::size_t k = 0; k <= first_parts; ++k) {
      const double t = two_pi * static_cast<double>(k % first_parts) / first_parts;
      cosines[k] = std::cos(t);
      sines[k] = std::sin(t);
    }
    for (std::size_t depth = 0; depth < most; ++depth)
      to_middle[depth] =
          0.5 / std::cos(0.5 * std::ldexp(two_pi / first_parts, -static_cast<int>(depth)));
  }
};

const Halvings halvings;

void collect_roots(const TrigonometricPolynomial& f, double bound, std::size_t depth,
                   const Sample& begin, const Sample& end, std::vector<Root>& roots) {
  const double width = end.t - begin.t;
  const bool sign_changes = (begin.value < 0.0) != (end.value < 0.0);
  if (!sign_changes &&
      std::min(std::abs(begin.value), std::abs(end.value)) > bound * width * width / 8.0)
    return; // f stays within bound w^2 / 8 of its chord
  const double scale = halvings.to_middle[depth];
  Sample middle{0.5 * (begin.t + end.t), scale * (begin.cosine + end.cosine),
                scale * (begin.sine + end.sine), 0.0};
  const auto jet = f.at(middle.cosine, middle.sine);
  middle.value = jet.value;
  const bool is_monotone = std::abs(jet.slope) > 0.5 * bound * width;
  if (sign_changes && (is_monotone || width < closest_roots)) {
    roots.push_back(bracketed_root(f, bound, begin.t, end.t, middle, begin.value < 0.0));
    return;
  }
  if (is_monotone || width < closest_roots)
    return;
  collect_roots(f, bound, depth + 1, begin, middle, roots);
  collect_roots(f, bound, depth + 1, middle, end, roots);
}

std::vector<Root> roots_of(const TrigonometricPolynomial& f) {
  std::vector<Root> roots;
  if (std::abs(f.k) > f.first_wave() + f.second_wave())
    return roots; // the waves cannot reach zero
  roots.reserve(4);
  const double bound = f.largest_curvature();
  const auto sample = [&f](std::size_t part) {
    const double c = halvings.cosines[part], s = halvings.sines[part];
    return Sample{two_pi * static_cast<double>(part) / Halvings::first_parts, c, s,
                  f.at(c, s).value};
  };
  Sample begin = sample(0);
  for (std::size_t part = 1; part <= Halvings::first_parts; ++part) {
    const Sample end = sample(part);
    collect_roots(f, bound, 0, begin, end, roots);
    begin = end;
  }
  return roots;
}

/// Whether the line across the centres' connection in j's own unit circle separates i from j.
/// (False says nothing.)
bool are_apart(const PlaneEllipse& i, const PlaneEllipse& j) {
  const InUnitCircle seen = in_unit_circle(i, j);
  const double squared = seen.d.squaredNorm();
  // with n = d / |d|: i reaches sqrt((p.n)^2 + (q.n)^2) towards the circle's centre
  const double pd = seen.p.dot(seen.d), qd = seen.q.dot(seen.d);
  const double beyond = squared - std::sqrt(squared);
  return beyond > 0.0 && beyond * beyond > pd * pd + qd * qd;
}

ArcEnd arc_end(double cosine, double sine) { return {turn_of(cosine, sine), cosine, sine}; }

/// Appends the arc from a root to the next one at parameter `end` where f < 0; lenses with a chord
/// below `limit` are left out.
void append_arc(const Root& begin, const Root& next, double end, const PlaneEllipse& i,
                double limit, std::vector<ArcInterval>& result) {
  if (begin.rises || end <= begin.t)
    return;
  const double cosine = next.cosine - begin.cosine, sine = next.sine - begin.sine;
  if (end - begin.t < 0.5 &&
      Point(i.ux * cosine, i.uy * cosine + i.vy * sine).squaredNorm() < limit * limit)
    return;
  result.push_back({arc_end(begin.cosine, begin.sine), arc_end(next.cosine, next.sine)});
}

/// Appends the parts of an outline where f < 0, between its ascending roots.
void append_negative(const TrigonometricPolynomial& f, const std::vector<Root>& roots,
                     const PlaneEllipse& i, double limit, std::vector<ArcInterval>& result) {
  if (roots.empty() && f.at(1.0, 0.0).value < 0.0 && f.value(1.0) < 0.0)
    result.push_back({turn_begin, turn_end});
  for (std::size_t k = 0; k + 1 < roots.size(); ++k)
    append_arc(roots[k], roots[k + 1], roots[k + 1].t, i, limit, result);
  if (!roots.empty())
    append_arc(roots.back(), roots.front(), roots.front().t + two_pi, i, limit, result);
}

/// From each of the ascending roots to the next one.
template <class Visitor> void for_gaps(std::vector<Root>& roots, const Visitor& visit) {
  for (std::size_t k = 0; k + 1 < roots.size(); ++k)
    visit(roots[k], roots[k + 1].t);
  if (!roots.empty())
    visit(roots.back(), roots.front().t + two_pi);
}

/// The crossings of i with j as roots of f, the level of i along j. Both outlines run
/// counter-clockwise: where one enters the other leaves. Of crossings so close together that they
/// may have changed places, the value between them tells which is which.
std::vector<Root> seen_from_other(const std::vector<Root>& roots, const PlaneEllipse& i,
                                  const PlaneEllipse& j, const TrigonometricPolynomial& f) {
  constexpr double surely_ascending = 1.0e-7; // far above the rounding of slender outlines
  const InUnitCircle seen = in_unit_circle(i, j);
  std::vector<Root> result;
  result.reserve(roots.size());
  for (const Root& root : roots) {
    const Point p = seen.d + root.cosine * seen.p + root.sine * seen.q;
    const double t = std::atan2(p.y(), p.x());
    result.push_back({t < 0.0 ? t + two_pi : t, p.x(), p.y(), !root.rises});
  }
  std::sort(result.begin(), result.end(), [](const Root& a, const Root& b) { return a.t < b.t; });
  bool is_ascending = true;
  for_gaps(result, [&](const Root& root, double next) {
    is_ascending = is_ascending && next - root.t > surely_ascending;
  });
  if (!is_ascending)
    for_gaps(result, [&](Root& root, double next) {
      root.rises = !(f.value(0.5 * (root.t + next)) < 0.0);
    });
  return result;
}

} // namespace

double turn_of(double cosine, double sine) {
  const double r = sine / (std::abs(cosine) + std::abs(sine));
  return cosine < 0.0 ? 2.0 - r : r >= 0.0 ? r : 4.0 + r;
}

namespace {

/// The angle from one direction to another (rad), from 0 to 2 pi.
double angle_between(const ArcEnd& begin, const ArcEnd& end) {
  const double sine = begin.cosine * end.sine - begin.sine * end.cosine;
  const double cosine = begin.cosine * end.cosine + begin.sine * end.sine;
  const double turn = end.turn - begin.turn;
  const double squared = sine * sine;
  if (cosine > 0.0 && squared < 0.01 && turn < 2.0) { // arc sine by its series, to rounding
    double sum = 0.0;
    for (const double share : {143.0 / 10240.0, 231.0 / 13312.0, 63.0 / 2816.0, 35.0 / 1152.0,
                               5.0 / 112.0, 3.0 / 40.0, 1.0 / 6.0, 1.0})
      sum = share + squared * sum;
    return sine * sum;
  }
  const double angle = std::atan2(sine, cosine);
  const bool is_beyond = (angle < 0.0 && turn > 1.0) || (angle < 1.0 && turn > 3.0);
  return is_beyond ? angle + two_pi : angle;
}

} // namespace

double green(const PlaneEllipse& shape, const ArcInterval& arc) {
  const auto& [begin, end] = arc;
  if (begin.turn == turn_begin.turn && end.turn == turn_end.turn)
    return shape.area();
  const double cosine = end.cosine - begin.cosine, sine = end.sine - begin.sine;
  const Point along(shape.ux * cosine, shape.uy * cosine + shape.vy * sine);
  return 0.5 * (shape.ux * shape.vy * angle_between(begin, end) + cross(shape.centre, along));
}

std::vector<double> crossings(const PlaneEllipse& i, const PlaneEllipse& j) {
  if (are_apart(i, j) || are_apart(j, i))
    return {};
  const TrigonometricPolynomial f = level_along(i, j);
  std::vector<double> result;
  if (f.size() >= same_outline)
    for (const Root& root : roots_of(f))
      result.push_back(root.t);
  return result;
}

void append_covered(const PlaneEllipse& i, const PlaneEllipse& j, std::vector<ArcInterval>& of_i,
                    std::vector<ArcInterval>& of_j) {
  if (are_apart(i, j) || are_apart(j, i))
    return;
  const TrigonometricPolynomial along_i = level_along(i, j);
  if (along_i.size() < same_outline) {
    of_j.push_back({turn_begin, turn_end});
    return;
  }
  const double limit = shortest_chord * std::min(i.bounding_radius(), j.bounding_radius());
  const std::vector<Root> roots = roots_of(along_i);
  append_negative(along_i, roots, i, limit, of_i);
  const TrigonometricPolynomial along_j = level_along(j, i);
  append_negative(along_j, seen_from_other(roots, i, j, along_j), j, limit, of_j);
}

void append_beyond_line(const PlaneEllipse& i, const Point& normal, double offset,
                        std::vector<ArcInterval>& of_i) {
  // offset - normal . p(t) = k + c cos t + s sin t is negative beyond: about the direction m of
  // -(c, s) it is k - L cos(t - m)
  const double k = offset - normal.dot(i.centre);
  const double c = -(normal.x() * i.ux + normal.y() * i.uy), s = -normal.y() * i.vy;
  const double wave = std::sqrt(c * c + s * s);
  if (!(std::abs(k) < wave)) {
    if (k < 0.0)
      of_i.push_back({turn_begin, turn_end});
    return;
  }
  const double cos_w = k / wave, sin_w = std::sqrt((wave - k) * (wave + k)) / wave;
  const Point m(-c / wave, -s / wave),
      begin(m.x() * cos_w + m.y() * sin_w, m.y() * cos_w - m.x() * sin_w);
  const Point end(m.x() * cos_w - m.y() * sin_w, m.y() * cos_w + m.x() * sin_w);
  const Point along = end - begin;
  const double limit = shortest_chord * i.bounding_radius();
  const bool is_small =
      cos_w > 0.0 &&
      Point(i.ux * along.x(), i.uy * along.x() + i.vy * along.y()).squaredNorm() < limit * limit;
  if (!is_small)
    of_i.push_back({arc_end(begin.x(), begin.y()), arc_end(end.x(), end.y())});
}

} // namespace ellipsoid::post
