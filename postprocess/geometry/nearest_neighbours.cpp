// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "nearest_neighbours.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nanoflann.hpp>

namespace ellipsoid::post {
namespace {

/// Points as the tree wants them.
struct Cloud {
  std::vector<Vector3> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t n, std::size_t axis) const {
    return axis == 0 ? points[n].x : axis == 1 ? points[n].y : points[n].z;
  }
  template <class Bounds> bool kdtree_get_bbox(Bounds&) const { return false; }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud,
                                                 3, std::size_t>;

struct Found {
  double squared; ///< distance (length^2)
  std::size_t index;
};

class Finder {
 public:
  Finder(const std::vector<Vector3>& points, const PeriodicCell& cell, std::size_t count)
      : cloud_{wrapped(points, cell)}, tree_(3, cloud_), count_(count), indices_(count + 1),
        squares_(count + 1) {
    lower_ = upper_ = cloud_.points.front();
    for (const Vector3& p : cloud_.points) {
      lower_ = {std::min(lower_.x, p.x), std::min(lower_.y, p.y), std::min(lower_.z, p.z)};
      upper_ = {std::max(upper_.x, p.x), std::max(upper_.y, p.y), std::max(upper_.z, p.z)};
    }
  }

  std::vector<std::vector<std::size_t>> find(const PeriodicCell& cell) {
    std::vector<std::vector<Found>> found(cloud_.points.size());
    double farthest = 0.0; // no true neighbour is farther than the farthest one without images
    for (std::size_t n = 0; n < found.size(); ++n) {
      add_near(found[n], cloud_.points[n], n);
      farthest = std::max(farthest, found[n].back().squared);
    }
    const std::vector<Vector3> shifts = cell.shifts(std::sqrt(farthest));
    std::vector<std::vector<std::size_t>> result(found.size());
    for (std::size_t n = 0; n < found.size(); ++n) {
      for (std::size_t k = 1; k < shifts.size(); ++k) {
        const Vector3 image = cloud_.points[n] + shifts[k];
        if (squared_from_bounds(image) < found[n].back().squared)
          add_near(found[n], image, n);
      }
      for (const Found& f : found[n])
        result[n].push_back(f.index);
    }
    return result;
  }

 private:
  static std::vector<Vector3> wrapped(const std::vector<Vector3>& points,
                                      const PeriodicCell& cell) {
    std::vector<Vector3> result;
    for (const Vector3& p : points)
      result.push_back(cell.wrapped(p));
    return result;
  }

  double squared_from_bounds(const Vector3& p) const {
    const auto outside = [](double x, double low, double high) {
      return std::max({0.0, low - x, x - high});
    };
    const Vector3 d{outside(p.x, lower_.x, upper_.x), outside(p.y, lower_.y, upper_.y),
                    outside(p.z, lower_.z, upper_.z)};
    return dot(d, d);
  }

  /// Keeps the nearest ones of those known and those near `point`, all but the point itself.
  void add_near(std::vector<Found>& found, const Vector3& point, std::size_t itself) {
    const double query[3] = {point.x, point.y, point.z};
    const std::size_t count = tree_.knnSearch(query, count_ + 1, indices_.data(), squares_.data());
    for (std::size_t k = 0; k < count; ++k)
      if (indices_[k] != itself)
        found.push_back({squares_[k], indices_[k]});
    std::sort(found.begin(), found.end(), [](const Found& p, const Found& q) {
      return p.squared < q.squared || (p.squared == q.squared && p.index < q.index);
    });
    found.resize(std::min(found.size(), count_));
  }

  Cloud cloud_;
  Tree tree_;
  std::size_t count_;
  std::vector<std::size_t> indices_;
  std::vector<double> squares_;
  Vector3 lower_, upper_;
};

} // namespace

std::vector<std::vector<std::size_t>> nearest_neighbours(const std::vector<Vector3>& points,
                                                         const PeriodicCell& cell,
                                                         std::size_t count) {
  if (points.size() <= count)
    throw InputError(fmt::format("expected more than {} particles for as many neighbours, found {}",
                                 count, points.size()));
  return Finder(points, cell, count).find(cell);
}

} // namespace ellipsoid::post
