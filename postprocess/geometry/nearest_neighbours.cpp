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
      : m_cloud{wrapped(points, cell)}, m_tree(3, m_cloud), m_count(count), m_indices(count + 1),
        m_squares(count + 1) {
    m_lower = m_upper = m_cloud.points.front();
    for (const Vector3& p : m_cloud.points) {
      m_lower = {std::min(m_lower.x, p.x), std::min(m_lower.y, p.y), std::min(m_lower.z, p.z)};
      m_upper = {std::max(m_upper.x, p.x), std::max(m_upper.y, p.y), std::max(m_upper.z, p.z)};
    }
  }

  std::vector<std::vector<std::size_t>> find(const PeriodicCell& cell) {
    std::vector<std::vector<Found>> found(m_cloud.points.size());
    double farthest = 0.0; // no true neighbour is farther than the farthest one without images
    for (std::size_t n = 0; n < found.size(); ++n) {
      add_near(found[n], m_cloud.points[n], n);
      farthest = std::max(farthest, found[n].back().squared);
    }
    const std::vector<Vector3> shifts = cell.shifts(std::sqrt(farthest));
    std::vector<std::vector<std::size_t>> result(found.size());
    for (std::size_t n = 0; n < found.size(); ++n) {
      for (std::size_t k = 1; k < shifts.size(); ++k) {
        const Vector3 image = m_cloud.points[n] + shifts[k];
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
    const Vector3 d{outside(p.x, m_lower.x, m_upper.x), outside(p.y, m_lower.y, m_upper.y),
                    outside(p.z, m_lower.z, m_upper.z)};
    return dot(d, d);
  }

  /// Keeps the nearest ones of those known and those near `point`, all but the point itself.
  void add_near(std::vector<Found>& found, const Vector3& point, std::size_t itself) {
    const double query[3] = {point.x, point.y, point.z};
    const std::size_t count =
        m_tree.knnSearch(query, m_count + 1, m_indices.data(), m_squares.data());
    for (std::size_t k = 0; k < count; ++k)
      if (m_indices[k] != itself)
        found.push_back({m_squares[k], m_indices[k]});
    std::sort(found.begin(), found.end(), [](const Found& p, const Found& q) {
      return p.squared < q.squared || (p.squared == q.squared && p.index < q.index);
    });
    found.resize(std::min(found.size(), m_count));
  }

  Cloud m_cloud;
  Tree m_tree;
  std::size_t m_count;
  std::vector<std::size_t> m_indices;
  std::vector<double> m_squares;
  Vector3 m_lower, m_upper;
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
