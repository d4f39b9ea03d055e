// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "body_axes.h"

#include "quaternion_of_matrix.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

/// Scatters (squares of lengths) that differ by less of the largest one are equal: files of six
/// digits hold a body far from the origin to a thousandth of its size.
constexpr double same_scatter = 1.0e-2;
/// A scatter that is less of the largest one is none, for the same reason.
constexpr double no_scatter = 1.0e-5;

Vector3 across(const Vector3& d, const Vector3& axis) { return d - dot(d, axis) * axis; }

Vector3 any_across(const Vector3& axis) {
  const Vector3 other = std::abs(axis.x) < 0.6 ? Vector3{1.0, 0.0, 0.0} : Vector3{0.0, 1.0, 0.0};
  return normalized(across(other, axis));
}

/// The spheres of a body, seen from the middle of their centres.
class SphereCloud {
 public:
  SphereCloud(const Sphere* begin, const Sphere* end, const Vector3& centre)
      : begin_(begin), end_(end), centre_(centre) {}

  /// Scatter of the centres; its eigenvalues are in ascending order.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> scatter() const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Sphere* s = begin_; s != end_; ++s) {
      const Vector3 way = s->centre - centre_;
      const Eigen::Vector3d d(way.x, way.y, way.z);
      sum += d * d.transpose();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum);
  }

  /// The way to the first sphere for which a measure (length) is not small: the same sphere in
  /// every frame. No usual body has two spheres with this ratio of distances.
  template <class Measure> Vector3 reference(const Measure& measure) const {
    constexpr double not_small = 0.37; // of the largest
    const double largest = greatest([&](const Vector3& d, double) { return measure(d); });
    const Sphere* first = std::find_if(begin_, end_, [&](const Sphere& s) {
      return measure(s.centre - centre_) >= not_small * largest;
    });
    return first->centre - centre_;
  }

  /// Of the two directions along an axis the one in which the reference sphere lies.
  Vector3 with_sign(const Vector3& axis) const {
    const Vector3 d = reference([&](const Vector3& way) { return std::abs(dot(way, axis)); });
    return dot(d, axis) < 0.0 ? -axis : axis;
  }
  /// The direction across an axis in which the reference sphere lies.
  Vector3 direction_across(const Vector3& axis) const {
    const Vector3 d = reference([&](const Vector3& way) { return norm(across(way, axis)); });
    return normalized(across(d, axis));
  }

  double half_length(const Vector3& axis) const {
    return greatest([&](const Vector3& d, double r) { return std::abs(dot(d, axis)) + r; });
  }
  double half_width(const Vector3& axis) const {
    return greatest([&](const Vector3& d, double r) { return norm(across(d, axis)) + r; });
  }
  double reach() const {
    return greatest([](const Vector3& d, double r) { return norm(d) + r; });
  }

 private:
  template <class Measure> double greatest(const Measure& measure) const {
    double largest = 0.0;
    for (const Sphere* s = begin_; s != end_; ++s)
      largest = std::max(largest, measure(s->centre - centre_, s->radius));
    return largest;
  }

  const Sphere *begin_, *end_;
  Vector3 centre_;
};

BodyAxes with_axes(const Vector3& x, const Vector3& y, const Vector3& semiaxes,
                   KnownOrientation known) {
  return {quaternion_of(Rotation3{x, y, cross(x, y)}), semiaxes, known};
}

} // namespace

BodyAxes axes_of_body(const Sphere* begin, const Sphere* end, const Vector3& centre) {
  const SphereCloud cloud(begin, end, centre);
  const auto scatter = cloud.scatter();
  const auto axis = [&scatter](int k) {
    const Eigen::Vector3d v = scatter.eigenvectors().col(k);
    return Vector3{v.x(), v.y(), v.z()};
  };
  const double least = scatter.eigenvalues()(0), middle = scatter.eigenvalues()(1),
               largest = scatter.eigenvalues()(2);
  const double reach = cloud.reach();
  if (!(largest > no_scatter * reach * reach))
    return {{}, {reach, reach, reach}, KnownOrientation::none};
  const double same = same_scatter * largest;
  const bool is_round_across_longest = middle - least <= same;
  const bool is_round_across_shortest = largest - middle <= same;
  if (is_round_across_longest && is_round_across_shortest) {
    const Vector3 x = normalized(cloud.reference([](const Vector3& way) { return norm(way); }));
    return with_axes(x, cloud.direction_across(x), {reach, reach, reach}, KnownOrientation::whole);
  }
  if (is_round_across_shortest) {
    const Vector3 flat = axis(0), x = cloud.direction_across(flat);
    const double width = cloud.half_width(flat);
    return with_axes(x, cloud.with_sign(cross(flat, x)), {width, width, cloud.half_length(flat)},
                     KnownOrientation::whole);
  }
  const Vector3 x = cloud.with_sign(axis(2));
  if (is_round_across_longest) {
    const bool is_chain = middle <= no_scatter * largest;
    const double width = cloud.half_width(x);
    return with_axes(x, is_chain ? any_across(x) : cloud.direction_across(x),
                     {cloud.half_length(x), width, width},
                     is_chain ? KnownOrientation::axis : KnownOrientation::whole);
  }
  const Vector3 y = cloud.with_sign(axis(1));
  return with_axes(x, y,
                   {cloud.half_length(x), cloud.half_length(y), cloud.half_length(cross(x, y))},
                   KnownOrientation::whole);
}

} // namespace ellipsoid::post
