// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "orientation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

constexpr double degrees = 180.0 / 3.141592653589793238462643;

/// Angle of a direction without sign in the xy plane, 0 to 180 degrees.
double plane_angle(const Vector3& n) {
  const double angle = degrees * std::atan2(n.y, n.x);
  return angle < 0.0 ? angle + 180.0 : angle >= 180.0 ? angle - 180.0 : angle;
}

} // namespace

PrincipalAxes mean_dyad(const std::vector<Vector3>& directions) {
  PrincipalAxes result;
  if (directions.empty())
    return result;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Vector3& n : directions) {
    const Eigen::Vector3d v(n.x, n.y, n.z);
    sum += v * v.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      sum / static_cast<double>(directions.size()));
  for (int k = 0; k < 3; ++k)
    result.values[static_cast<std::size_t>(k)] = solver.eigenvalues()(2 - k);
  const Eigen::Vector3d axis = solver.eigenvectors().col(2);
  result.direction = {axis.x(), axis.y(), axis.z()};
  return result;
}

std::vector<double> angle_rose(const std::vector<Vector3>& directions, int bins) {
  std::vector<double> rose(static_cast<std::size_t>(bins), 0.0);
  for (const Vector3& n : directions) {
    const auto bin = static_cast<std::size_t>(plane_angle(n) / 180.0 * bins);
    rose[std::min(bin, rose.size() - 1)] += 1.0;
  }
  for (double& share : rose)
    share /= std::max(1.0, static_cast<double>(directions.size()));
  return rose;
}

Orientation orientation(const ParticleSet& set, const std::vector<std::size_t>& members, int bins) {
  std::vector<Vector3> axes;
  double cosine = 0.0, sine = 0.0;
  for (const std::size_t i : members) {
    axes.push_back(set.particles[i].long_axis());
    const double twice = 2.0 * std::atan2(axes.back().y, axes.back().x);
    cosine += std::cos(twice) / static_cast<double>(members.size());
    sine += std::sin(twice) / static_cast<double>(members.size());
  }
  Orientation result;
  const PrincipalAxes dyad = mean_dyad(axes);
  result.nematic_order = 1.5 * (dyad.values[0] - 1.0 / 3.0);
  result.director = dyad.direction;
  result.plane_order = std::hypot(cosine, sine);
  result.plane_angle_deg = 0.5 * degrees * std::atan2(sine, cosine);
  if (result.plane_angle_deg < 0.0)
    result.plane_angle_deg += 180.0;
  result.rose = angle_rose(axes, bins);
  return result;
}

} // namespace ellipsoid::post
