// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "insertion/body_in_space.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace ellipsoid {
namespace {

/// An ellipsoid as the unit ball, mapped by the lower triangular factor of its matrix (Cholesky):
/// x = centre + L u.
class MappedBall {
 public:
  MappedBall(const Vector3& centre, const SymmetricMatrix3& a, double longest)
      : centre_(centre), longest_(longest) {
    xx_ = std::sqrt(a.xx);
    yx_ = a.xy / xx_;
    zx_ = a.xz / xx_;
    yy_ = std::sqrt(std::max(0.0, a.yy - yx_ * yx_));
    zy_ = yy_ > 0.0 ? (a.yz - zx_ * yx_) / yy_ : 0.0;
    zz_ = std::sqrt(std::max(0.0, a.zz - zx_ * zx_ - zy_ * zy_));
  }

  Vector3 at(const Vector3& u) const {
    return centre_ + Vector3{xx_ * u.x, yx_ * u.x + yy_ * u.y, zx_ * u.x + zy_ * u.y + zz_ * u.z};
  }
  double longest() const { return longest_; } ///< no length is mapped to more than so many times it

 private:
  Vector3 centre_;
  double longest_, xx_, yx_, yy_, zx_, zy_, zz_;
};

/// A cube of the space of the unit ball.
struct Cube {
  Vector3 middle;
  double half;
};

/// Cubes that meet the ball are halved until the space has room around each, or a point of the ball
/// is outside. Larger cubes come first: a body that sticks out is found early.
bool is_inside_space(const MappedBall& ball, const RoomAround& room) {
  constexpr int most_cubes =
      200000; // a body that fits its space that closely is told to be outside
  const double root_three = std::sqrt(3.0);
  std::deque<Cube> cubes{{{}, 1.0}};
  for (int count = 0; !cubes.empty(); ++count) {
    const Cube cube = cubes.front();
    cubes.pop_front();
    const double distance = norm(cube.middle), radius = root_three * cube.half;
    if (distance - radius > 1.0)
      continue;
    // no point that the cube and the ball share is farther from this one than `radius`
    const Vector3 nearest = distance > 1.0 ? (1.0 / distance) * cube.middle : cube.middle;
    const double enough = radius * ball.longest(), found = room(ball.at(nearest), enough);
    if (found < 0.0 || radius < undecided_share || count == most_cubes)
      return false;
    if (found >= enough)
      continue;
    const double half = 0.5 * cube.half;
    for (const double x : {-half, half})
      for (const double y : {-half, half})
        for (const double z : {-half, half})
          cubes.push_back({cube.middle + Vector3{x, y, z}, half});
  }
  return true;
}

bool ball_is_inside(const Vector3& centre, double radius, const RoomAround& room) {
  const double r2 = radius * radius;
  return room(centre, radius) >= radius ||
         is_inside_space(MappedBall(centre, {r2, r2, r2, 0.0, 0.0, 0.0}, radius), room);
}

} // namespace

bool is_inside_space(const SolidBody& body, const RoomAround& room) {
  if (room(body.centre, body.bounding_radius) >= body.bounding_radius)
    return true;
  if (body.is_smooth())
    return is_inside_space(MappedBall(body.centre, body.shape.a_matrix, body.bounding_radius),
                           room);
  const SphereCentres spheres(body.spheres);
  for (int k = 0; k < body.spheres.body->count(); ++k)
    if (!ball_is_inside(body.centre + spheres.at(k), spheres.radius(k), room))
      return false;
  return true;
}

} // namespace ellipsoid
