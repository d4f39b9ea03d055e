// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall/surface_points.h"

#include "ellipsoid/ellipsoid_overlap.h"
#include "wall/wall_tolerances.h"

#include <algorithm>

namespace ellipsoid {

namespace {

using Triple = std::array<double, 3>;

/// Newton's method kept inside a bracket, which bisection halves where a step would leave it.
/// @param[in] evaluate f and f' at a point; f < 0 at `low`, f > 0 at `high` (or zero at the ends)
template <class Evaluate>
double find_root(double low, double high, double start, const Evaluate& evaluate) {
  double x = start;
  for (int k = 0; k < wall_tolerance::search_limit; ++k) {
    const auto [value, slope] = evaluate(x);
    const double step = -value / slope;
    if (std::fabs(step) <= wall_tolerance::search * std::fabs(x) ||
        high - low <= wall_tolerance::search * high)
      return x;
    (value < 0.0 ? low : high) = x;
    x += step;
    if (!(x > low && x < high))
      x = 0.5 * (low + high);
  }
  return x;
}

/// The nearest point is y_i = a_i^2 p_i / (a_i^2 + t) with t from sum (y_i / a_i)^2 = 1, the
/// largest root (Eberly, Distance from a point to an ellipse, an ellipsoid, or a hyperellipsoid,
/// 2013). The unknown is the smallest denominator a_m^2 + t, so that none suffers from
/// cancellation.
struct NearestPoint {
  Triple gap;    // a_i^2 - a_m^2 (length^2)
  Triple weight; // a_i |p_i| (length^2)

  NearestPoint(const Triple& a, const Triple& p, double smallest) {
    for (std::size_t i = 0; i < 3; ++i) {
      gap[i] = (a[i] - smallest) * (a[i] + smallest);
      weight[i] = a[i] * std::fabs(p[i]);
    }
  }

  double lowest() const { // each term alone must not exceed 1
    double bound = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      bound = std::max(bound, weight[i] - gap[i]);
    return bound;
  }
  double highest() const { // every denominator is at least the smallest one
    return std::sqrt(weight[0] * weight[0] + weight[1] * weight[1] + weight[2] * weight[2]);
  }

  /// 1 / sqrt(sum) - 1, which is nearly linear, and its derivative.
  std::pair<double, double> operator()(double smallest_denominator) const {
    double sum = 0.0, slope = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double denominator = gap[i] + smallest_denominator;
      const double term = denominator > 0.0 ? weight[i] / denominator : 0.0;
      sum += term * term;
      slope += denominator > 0.0 ? term * term / denominator : 0.0;
    }
    const double root = std::sqrt(sum);
    return {1.0 / root - 1.0, slope / (sum * root)};
  }
};

/// Normal where the point lies on the medial axis: its component along the shortest axis is free.
Vector3 medial_normal(const Triple& a, const Triple& p, const NearestPoint& f,
                      std::size_t shortest) {
  Triple n{0.0, 0.0, 0.0};
  double rest = 1.0;
  for (std::size_t i = 0; i < 3; ++i)
    if (f.gap[i] > 0.0) {
      n[i] = p[i] / f.gap[i];
      rest -= a[i] * a[i] * n[i] * n[i]; // (y_i / a_i)^2, y_i = a_i^2 n_i
    }
  n[shortest] = std::sqrt(std::fmax(0.0, rest)) / a[shortest];
  return normalized(Vector3{n[0], n[1], n[2]});
}

} // namespace

Vector3 nearest_normal(const Vector3& semiaxes, const Vector3& point) {
  const Triple a{semiaxes.x, semiaxes.y, semiaxes.z}, p{point.x, point.y, point.z};
  const auto shortest = static_cast<std::size_t>(std::min_element(a.begin(), a.end()) - a.begin());
  const NearestPoint f(a, p, a[shortest]);
  const double low = f.lowest(), high = f.highest();
  if (!(low > 0.0) && (!(high > 0.0) || f(0.0).first >= 0.0))
    return medial_normal(a, p, f, shortest);
  const double t = find_root(low, high, low > 0.0 ? low : high, f);
  return normalized(Vector3{p[0] / (f.gap[0] + t), p[1] / (f.gap[1] + t), p[2] / (f.gap[2] + t)});
}

Shadow shadow_along(const EllipsoidShape& shape, const Vector3& direction) {
  const TangentFrame t(direction);
  const Vector3 a_first = shape.a_matrix * t.first, a_second = shape.a_matrix * t.second;
  const double xx = dot(t.first, a_first), xy = dot(t.first, a_second),
               yy = dot(t.second, a_second);
  // cosine >= 0 and sine of half the angle of (xx - yy, 2 xy), without cancellation
  const double half = 0.5 * (xx - yy), radius = std::hypot(half, xy);
  double cosine = 1.0, sine = 0.0;
  if (half >= 0.0 && radius > 0.0) {
    cosine = std::sqrt(0.5 * (1.0 + half / radius));
    sine = 0.5 * xy / (radius * cosine);
  } else if (radius > 0.0) {
    sine = std::copysign(std::sqrt(0.5 * (1.0 - half / radius)), xy);
    cosine = 0.5 * xy / (radius * sine);
  }
  const double major = 0.5 * (xx + yy) + radius;
  Shadow shadow;
  shadow.major = cosine * t.first + sine * t.second;
  shadow.minor = cosine * t.second - sine * t.first;
  shadow.a = std::sqrt(major);
  shadow.b = std::min(shadow.a, std::sqrt((xx * yy - xy * xy) / major));
  return shadow;
}

Vector3 nearest_normal(const Shadow& shadow, const Vector3& point) {
  // an ellipse is an ellipsoid with the point in its plane of symmetry
  const Vector3 semiaxes{shadow.a, shadow.b, shadow.a};
  const Vector3 n =
      nearest_normal(semiaxes, {dot(shadow.major, point), dot(shadow.minor, point), 0.0});
  return n.x * shadow.major + n.y * shadow.minor;
}

namespace {

/// Half the derivative of the squared distance from the point (x, y) to the ellipse's point
/// (a cos, b sin), and its own derivative, with the sign turned so that it rises at a maximum.
struct DistanceSlope {
  double ax, by, difference; // a x, b y, a^2 - b^2 (length^2)

  std::pair<double, double> operator()(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {difference * s * c - ax * s + by * c, difference * (c * c - s * s) - ax * c - by * s};
  }
};

} // namespace

FarthestNormals farthest_normals(const Shadow& shadow, const Vector3& point) {
  const double px = dot(shadow.major, point), py = dot(shadow.minor, point);
  const double a = shadow.a, b = shadow.b;
  const double ax = a * std::fabs(px), by = b * std::fabs(py), difference = (a - b) * (a + b);
  // in the frame in which the point has no positive coordinate
  const double side_x = px > 0.0 ? -1.0 : 1.0, side_y = py > 0.0 ? -1.0 : 1.0;
  FarthestNormals result;
  const auto add = [&](double sign, double angle) {
    const double nx = sign * side_x * b * std::cos(angle), ny = side_y * a * std::sin(angle);
    const double scale = 1.0 / std::hypot(nx, ny);
    result.normal[static_cast<std::size_t>(result.count++)] =
        (scale * nx) * shadow.major + (scale * ny) * shadow.minor;
  };
  // The farthest point of all lies in the quadrant opposite to the point's.
  const double half_pi = 0.5 * M_PI;
  const double start = std::min(half_pi, std::atan2(by, ax + difference));
  add(1.0, by > 0.0 ? find_root(0.0, half_pi, start, DistanceSlope{-ax, -by, difference}) : 0.0);
  // A second maximum, at the other end of the major axis, exists where the point lies within the
  // ellipse's evolute, (a x)^(2/3) + (b y)^(2/3) < (a^2 - b^2)^(2/3).
  const double root_x = std::cbrt(ax), root_y = std::cbrt(by);
  if (!(root_x * root_x + root_y * root_y < std::cbrt(difference * difference)))
    return result;
  const double turn = std::atan2(root_y, root_x); // tan^3 = b y / (a x): least slope
  add(-1.0, by > 0.0 ? find_root(0.0, turn, 0.5 * turn, DistanceSlope{ax, -by, difference}) : 0.0);
  return result;
}

} // namespace ellipsoid
