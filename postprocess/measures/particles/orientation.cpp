// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "orientation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

constexpr double degrees = 180.0 / 3.141592653589793238462643;

/// Semi-axes that differ by less are equal: six digits of a file.
constexpr double same_axis = 1.0e-5;

double component(const Vector3& v, std::size_t k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

/// Angle of a direction without sign in a plane, 0 to 180 degrees.
double plane_angle(const Vector3& n, const AnglePlane& plane) {
  const double angle = degrees * std::atan2(component(n, plane.second), component(n, plane.first));
  return angle < 0.0 ? angle + 180.0 : angle >= 180.0 ? angle - 180.0 : angle;
}

/// The semi-axes in descending order, and where they are in the body.
std::array<std::pair<double, std::size_t>, 3> sorted_axes(const Particle& p) {
  std::array<std::pair<double, std::size_t>, 3> axes{
      {{p.semiaxes.x, 0}, {p.semiaxes.y, 1}, {p.semiaxes.z, 2}}};
  std::stable_sort(axes.begin(), axes.end(),
                   [](const auto& p1, const auto& p2) { return p1.first > p2.first; });
  return axes;
}

bool is_triaxial(const Particle& p) {
  const auto axes = sorted_axes(p);
  return axes[0].first > (1.0 + same_axis) * axes[1].first &&
         axes[1].first > (1.0 + same_axis) * axes[2].first;
}

Eigen::Vector3d eigen(const Vector3& v) { return {v.x, v.y, v.z}; }

/// Allen 1990, Liquid Crystals 8, 499-511: 1/3 (X.Qxx.X + Y.Qyy.Y - X.Qyy.X - Y.Qxx.Y) with Q of
/// the middle (x) and the shortest (y) axes, and X, Y across the director so that it is largest.
double biaxial_order(const std::vector<std::array<Vector3, 3>>& axes, const Vector3& director) {
  Eigen::Matrix3d difference = Eigen::Matrix3d::Zero();
  for (const auto& [longest, middle, shortest] : axes) {
    (void)longest;
    const Eigen::Vector3d m = eigen(middle), s = eigen(shortest);
    difference += 1.5 * (m * m.transpose() - s * s.transpose());
  }
  difference /= static_cast<double>(axes.size());
  const Eigen::Vector3d z = eigen(director), x = z.unitOrthogonal(), y = z.cross(x);
  Eigen::Matrix2d across;
  across << x.dot(difference * x), x.dot(difference * y), y.dot(difference * x),
      y.dot(difference * y);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(across, Eigen::EigenvaluesOnly);
  return (solver.eigenvalues()(1) - solver.eigenvalues()(0)) / 3.0;
}

/// Mean and standard deviation of the angles in (-90, 90].
void add_flow_angle(Orientation& result, const std::vector<Vector3>& axes,
                    const AnglePlane& plane) {
  const double count = static_cast<double>(axes.size());
  double squares = 0.0;
  const auto angle_of = [&](const Vector3& n) {
    const double angle = plane_angle(n, plane);
    return angle > 90.0 ? angle - 180.0 : angle;
  };
  for (const Vector3& n : axes)
    result.flow_angle_deg += angle_of(n) / count;
  for (const Vector3& n : axes)
    squares += (angle_of(n) - result.flow_angle_deg) * (angle_of(n) - result.flow_angle_deg);
  result.flow_angle_deviation_deg = axes.size() > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;
}

} // namespace

BodyAxis body_axis(const Particle& particle) {
  const auto axes = sorted_axes(particle);
  const double s1 = axes[0].first, s2 = axes[1].first, s3 = axes[2].first;
  if (s1 <= (1.0 + same_axis) * s3)
    return BodyAxis::none;
  return s1 * s3 < s2 * s2 ? BodyAxis::shortest : BodyAxis::longest;
}

std::array<Vector3, 3> axes_by_length(const Particle& particle) {
  const Rotation3 r = rotation(particle.orientation);
  const Vector3* const columns[3] = {&r.column_x, &r.column_y, &r.column_z};
  const auto axes = sorted_axes(particle);
  return {*columns[axes[0].second], *columns[axes[1].second], *columns[axes[2].second]};
}

PrincipalAxes mean_dyad(const std::vector<Vector3>& directions) {
  PrincipalAxes result;
  if (directions.empty())
    return result;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Vector3& n : directions)
    sum += eigen(n) * eigen(n).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      sum / static_cast<double>(directions.size()));
  for (int k = 0; k < 3; ++k)
    result.values[static_cast<std::size_t>(k)] = solver.eigenvalues()(2 - k);
  const Eigen::Vector3d axis = solver.eigenvectors().col(2);
  result.direction = {axis.x(), axis.y(), axis.z()};
  return result;
}

std::vector<double> angle_rose(const std::vector<Vector3>& directions, int bins,
                               const AnglePlane& plane) {
  std::vector<double> rose(static_cast<std::size_t>(bins), 0.0);
  for (const Vector3& n : directions) {
    const auto bin = static_cast<std::size_t>(plane_angle(n, plane) / 180.0 * bins);
    rose[std::min(bin, rose.size() - 1)] += 1.0;
  }
  for (double& share : rose)
    share /= std::max(1.0, static_cast<double>(directions.size()));
  return rose;
}

Orientation orientation(const ParticleSet& set, const std::vector<std::size_t>& members,
                        BodyAxis axis, int bins, const AnglePlane& plane) {
  std::vector<Vector3> axes;
  std::vector<std::array<Vector3, 3>> triaxial;
  double cosine = 0.0, sine = 0.0;
  for (const std::size_t i : members) {
    const std::array<Vector3, 3> by_length = axes_by_length(set.particles[i]);
    axes.push_back(axis == BodyAxis::shortest ? by_length[2] : by_length[0]);
    if (is_triaxial(set.particles[i]))
      triaxial.push_back(by_length);
    const double twice =
        2.0 * std::atan2(component(axes.back(), plane.second), component(axes.back(), plane.first));
    cosine += std::cos(twice) / static_cast<double>(members.size());
    sine += std::sin(twice) / static_cast<double>(members.size());
  }
  Orientation result;
  const PrincipalAxes dyad = mean_dyad(axes);
  result.nematic_order = 1.5 * (dyad.values[0] - 1.0 / 3.0);
  result.director = dyad.direction;
  if (!triaxial.empty()) {
    std::vector<Vector3> longest;
    for (const auto& by_length : triaxial)
      longest.push_back(by_length[0]);
    result.biaxial_order = biaxial_order(triaxial, mean_dyad(longest).direction);
  }
  result.plane_order = std::hypot(cosine, sine);
  result.plane_angle_deg = 0.5 * degrees * std::atan2(sine, cosine);
  if (result.plane_angle_deg < 0.0)
    result.plane_angle_deg += 180.0;
  add_flow_angle(result, axes, plane);
  result.rose = angle_rose(axes, bins, plane);
  return result;
}

} // namespace ellipsoid::post
