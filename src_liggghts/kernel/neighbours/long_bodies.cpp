// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "neighbours/long_bodies.h"

#include "math/vector3.h"
#include "vectorised/prefetch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ellipsoid {

namespace {

/// From this ratio of the longest to the shortest semi-axis on.
constexpr double long_ratio = 4.0;
/// Radius of the balls over that of the capsule: few balls, and few others near each.
constexpr double ball_ratio = 3.5;
/// Bounds that are rounded in another way count as near.
constexpr double rounding = 1e-9;

/// Balls that cover a capsule: their number, and where the last one is along half_length (the
/// first one is opposite).
struct Row {
  std::size_t count;
  double end;    ///< share of half_length
  double radius; ///< (length)
};

/// A ball of radius R around a place of the axis covers the capsule for sqrt(R^2 - r^2) to either
/// side, and the capsule's end as far as R - r from the end of its segment.
Row row_of_balls(double half_length, double radius) {
  const double ball = ball_ratio * radius, from_end = ball - radius;
  if (half_length <= from_end)
    return {1, 0.0, half_length + radius};
  const double way = half_length - from_end;
  const double spacing = 2.0 * std::sqrt(ball * ball - radius * radius);
  return {1 + static_cast<std::size_t>(std::ceil(2.0 * way / spacing)), way / half_length, ball};
}

/// Square of the least distance of two segments.
/// @param[in] distance from the middle of the first to that of the second (length)
/// @param[in] u, v from the middles to an end (length)
double segment_distance_squared(const Vector3& distance, const Vector3& u, const Vector3& v) {
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const double ud = dot(u, distance), vd = dot(v, distance);
  const double determinant = uu * vv - uv * uv;
  const auto on_segment = [](double share) { return std::clamp(share, -1.0, 1.0); };
  double s = determinant > 1e-12 * uu * vv ? on_segment((ud * vv - uv * vd) / determinant) : 0.0;
  const double t = vv > 0.0 ? on_segment((s * uv - vd) / vv) : 0.0;
  s = uu > 0.0 ? on_segment((ud + t * uv) / uu) : 0.0;
  const Vector3 shortest = distance + t * v - s * u;
  return dot(shortest, shortest);
}

/// How far an ellipsoid reaches along `distance`, times the length of that (length^2).
double reach(const Vector3 (&axes)[3], const Vector3& distance) {
  const double x = dot(axes[0], distance), y = dot(axes[1], distance), z = dot(axes[2], distance);
  return std::sqrt(x * x + y * y + z * z);
}

} // namespace

bool LongBodies::is_long_or_flat(const double* semiaxes) {
  const auto [least, largest] = std::minmax({semiaxes[0], semiaxes[1], semiaxes[2]});
  return largest >= long_ratio * least;
}

LongBodies::Body LongBodies::body_of(const BodyRows& bodies, std::size_t k) {
  const double *x = bodies.centres + 3 * k, *q = bodies.quaternions + 4 * k;
  const BodyBounds& bounds = bodies.bounds[k];
  const Rotation3 turned = rotation({q[0], q[1], q[2], q[3]});
  const Vector3 columns[] = {turned.column_x, turned.column_y, turned.column_z};
  Body body;
  body.centre = {x[0], x[1], x[2]};
  body.axes[0] = bounds.semiaxes.x * columns[0];
  body.axes[1] = bounds.semiaxes.y * columns[1];
  body.axes[2] = bounds.semiaxes.z * columns[2];
  body.radius = bounds.capsule_radius;
  body.half_length = bounds.half_length * columns[bounds.capsule_axis];
  body.balls = 0;
  return body;
}

void LongBodies::build(const BodyRows& bodies, double margin) {
  both_margins_ = 2.0 * margin;
  bodies_.clear();
  body_of_ball_.clear();
  last_asker_.assign(bodies.count, -1);
  bodies_.reserve(bodies.count);
  std::size_t balls = 0;
  for (std::size_t k = 0; k < bodies.count; ++k) {
    bodies_.push_back(body_of(bodies, k));
    bodies_.back().balls = balls;
    balls += row_of_balls(norm(bodies_.back().half_length), bodies_.back().radius).count;
  }
  std::vector<double> centres, radii;
  centres.reserve(3 * balls);
  radii.reserve(balls);
  body_of_ball_.reserve(balls);
  for (std::size_t k = 0; k < bodies.count; ++k) {
    const Body& body = bodies_[k];
    const Row row = row_of_balls(norm(body.half_length), body.radius);
    for (std::size_t ball = 0; ball < row.count; ++ball) {
      const double share =
          row.count == 1
              ? 0.0
              : row.end *
                    (2.0 * static_cast<double>(ball) / static_cast<double>(row.count - 1) - 1.0);
      const Vector3 centre = body.centre + share * body.half_length;
      centres.insert(centres.end(), {centre.x, centre.y, centre.z});
      radii.push_back(row.radius + margin);
      body_of_ball_.push_back(static_cast<int>(k));
    }
  }
  grids_.build(centres.data(), radii.data(), radii.size(), {1.0, 0.0});
}

bool LongBodies::may_be_near(const Body& a, const Body& b) const {
  const Vector3 distance = b.centre - a.centre;
  const double capsules = (1.0 + rounding) * (a.radius + b.radius + both_margins_);
  if (segment_distance_squared(distance, a.half_length, b.half_length) > capsules * capsules)
    return false;
  const double squared = dot(distance, distance);
  return squared <= (1.0 + rounding) * (reach(a.axes, distance) + reach(b.axes, distance) +
                                        both_margins_ * std::sqrt(squared));
}

/// Bodies whose balls are near those of body i.
void LongBodies::collect(int i) {
  near_.clear();
  const auto k = static_cast<std::size_t>(i);
  const std::size_t end = k + 1 < bodies_.size() ? bodies_[k + 1].balls : body_of_ball_.size();
  for (std::size_t ball = bodies_[k].balls; ball < end; ++ball)
    for (const int other : grids_.find(static_cast<int>(ball))) {
      const int j = body_of_ball_[static_cast<std::size_t>(other)];
      int& last_asker = last_asker_[static_cast<std::size_t>(j)];
      if (j == i || last_asker == i)
        continue;
      last_asker = i;
      prefetch(&bodies_[static_cast<std::size_t>(j)]);
      near_.push_back(j);
    }
}

const std::vector<int>& LongBodies::find(int i) {
  collect(i);
  const Body& own = bodies_[static_cast<std::size_t>(i)];
  near_.erase(std::remove_if(near_.begin(), near_.end(),
                             [this, &own](int j) {
                               return !may_be_near(own, bodies_[static_cast<std::size_t>(j)]);
                             }),
              near_.end());
  return near_;
}

} // namespace ellipsoid
