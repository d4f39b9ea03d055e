// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "mesh_clump.h"

#include "input_error.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <queue>
#include <utility>

namespace ellipsoid::post {
namespace {

constexpr int ball_candidates = 4000, outline_points = 12000;
/// Volume is counted on as many voxels as a cube of so many along each side has, at most so many
/// along one: long and flat bodies have their voxels where they are.
constexpr int voxels_of_cube = 64, most_voxels_along = 512;
constexpr int search_columns = 150; ///< of the search for a count, confirmed with more
constexpr int most_shrinkings = 40;
constexpr int rim_voxels = 4; ///< about the body, where spheres may stick out

/// Balls that overlap by less than this share of the smaller radius would come apart by rounding.
constexpr double least_overlap = 1e-3;

struct Ball {
  Vector3 centre;
  double radius = 0.0;
};

/// The largest ball inside that touches the surface at a point of it.
Ball shrunken_ball(const TriangleTree& tree, const MeshPoint& point, double size) {
  double radius = size;
  for (int i = 0; i < most_shrinkings; ++i) {
    const Vector3 centre = point.position - radius * point.normal, q = tree.nearest(centre),
                  apart = point.position - q;
    const double along = dot(apart, point.normal);
    if (norm(q - centre) >= radius * (1.0 - 1e-9) || !(along > 0.0))
      break;
    radius = std::min(radius * (1.0 - 1e-12), dot(apart, apart) / (2.0 * along));
  }
  const Vector3 centre = point.position - radius * point.normal;
  return {centre, norm(tree.nearest(centre) - centre)};
}

/// Places of a cubic grid, whether they are inside, and whether a ball holds them.
class Voxels {
 public:
  explicit Voxels(const Solid& solid) {
    const Vector3 size = solid.box.upper - solid.box.lower;
    const double width = std::max(std::cbrt(size.x * size.y * size.z) / voxels_of_cube,
                                  std::max({size.x, size.y, size.z}) / most_voxels_along);
    const Vector3 margin = rim_voxels * Vector3{width, width, width};
    grid_ = columns_over(solid.box, {solid.box.lower - margin, solid.box.upper + margin},
                         static_cast<int>(std::ceil(std::max(size.x, size.y) / width - 1e-9)));
    const int inside = static_cast<int>(std::ceil(size.z / width - 1e-9));
    width_z_ = size.z / inside;
    nz_ = inside + 2 * rim_voxels;
    z0_ = solid.box.lower.z - rim_voxels * width_z_;
    const SolidColumns columns = solid.columns(grid_);
    uncovered_.resize(columns.size() * static_cast<std::size_t>(nz_), false);
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (const ColumnPart& part : columns[c])
        for (int k = 0; k < nz_; ++k)
          if (z(k) > part.from && z(k) < part.to)
            uncovered_[c * static_cast<std::size_t>(nz_) + static_cast<std::size_t>(k)] = true;
  }

  double z(int k) const { return z0_ + (k + 0.5) * width_z_; }
  const ColumnGrid& grid() const { return grid_; }
  int nz() const { return nz_; }
  bool is_uncovered(std::size_t voxel) const { return uncovered_[voxel]; }

  int count_uncovered(const Ball& ball) const {
    int count = 0;
    for_each_uncovered(ball, [&count](std::size_t) { ++count; });
    return count;
  }
  void cover(const Ball& ball) {
    for_each_uncovered(ball, [this](std::size_t voxel) { uncovered_[voxel] = false; });
  }

  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(i) +
            static_cast<std::size_t>(grid_.nx) * static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(nz_) +
           static_cast<std::size_t>(k);
  }

 private:
  template <class Visit> void for_each_uncovered(const Ball& ball, const Visit& visit) const {
    const auto [i0, i1] = range(ball.centre.x, ball.radius, grid_.x0, grid_.width_x, grid_.nx);
    const auto [j0, j1] = range(ball.centre.y, ball.radius, grid_.y0, grid_.width_y, grid_.ny);
    const auto [k0, k1] = range(ball.centre.z, ball.radius, z0_, width_z_, nz_);
    for (int j = j0; j < j1; ++j)
      for (int i = i0; i < i1; ++i)
        for (int k = k0; k < k1; ++k) {
          const std::size_t voxel = index(i, j, k);
          const Vector3 apart = Vector3{grid_.x(i), grid_.y(j), z(k)} - ball.centre;
          if (uncovered_[voxel] && dot(apart, apart) < ball.radius * ball.radius)
            visit(voxel);
        }
  }

  static std::array<int, 2> range(double centre, double radius, double begin, double w, int count) {
    return {std::clamp(static_cast<int>((centre - radius - begin) / w - 0.5), 0, count),
            std::clamp(static_cast<int>((centre + radius - begin) / w + 1.5), 0, count)};
  }

  ColumnGrid grid_;
  int nz_ = 0;
  double z0_ = 0.0, width_z_ = 0.0;
  std::vector<bool> uncovered_;
};

bool touches(const Ball& ball, const SphereSet& placed) {
  for (std::size_t k = 0; k < placed.radii.size(); ++k)
    if (norm(ball.centre - placed.centres[k]) <
        ball.radius + placed.radii[k] - least_overlap * std::min(ball.radius, placed.radii[k]))
      return true;
  return placed.radii.empty();
}

/// What a ball adds only falls while others are placed: it is counted again when it leads. Balls
/// that lead and touch none of those placed wait for the next one.
SphereSet ordered_by_gain(const std::vector<Ball>& balls, Voxels& voxels) {
  std::priority_queue<std::pair<int, std::size_t>> leaders;
  for (std::size_t k = 0; k < balls.size(); ++k)
    leaders.push({voxels.count_uncovered(balls[k]), k});
  SphereSet placed;
  std::vector<std::pair<int, std::size_t>> waiting;
  while (!leaders.empty() && placed.count() < largest_set_count) {
    const std::size_t k = leaders.top().second;
    leaders.pop();
    const int gain = voxels.count_uncovered(balls[k]);
    if (gain == 0)
      continue;
    if (!leaders.empty() && gain < leaders.top().first) {
      leaders.push({gain, k});
      continue;
    }
    if (!touches(balls[k], placed)) {
      waiting.push_back({gain, k});
      continue;
    }
    voxels.cover(balls[k]);
    placed.centres.push_back(balls[k].centre);
    placed.radii.push_back(balls[k].radius);
    for (const auto& one : waiting)
      leaders.push(one);
    waiting.clear();
  }
  return placed;
}

/// The length by which all radii grow: where as much of what is missing is gained as sticks out.
double best_growth(const SphereSet& set, const Solid& solid) {
  const Voxels voxels(solid);
  std::vector<std::pair<double, int>> steps; // growth that reaches a voxel, and what that is worth
  for (int j = 0; j < voxels.grid().ny; ++j)
    for (int i = 0; i < voxels.grid().nx; ++i)
      for (int k = 0; k < voxels.nz(); ++k) {
        const Vector3 p{voxels.grid().x(i), voxels.grid().y(j), voxels.z(k)};
        double gap = std::numeric_limits<double>::infinity();
        for (std::size_t m = 0; m < set.radii.size(); ++m)
          gap = std::min(gap, norm(p - set.centres[m]) - set.radii[m]);
        if (gap > 0.0)
          steps.emplace_back(gap, voxels.is_uncovered(voxels.index(i, j, k)) ? 1 : -1);
      }
  std::sort(steps.begin(), steps.end());
  double best = 0.0;
  long worth = 0, most = 0;
  for (const auto& [growth, change] : steps) {
    worth += change;
    if (worth > most) {
      most = worth;
      best = growth;
    }
  }
  return best;
}

Solid solid_of(const std::vector<Triangle3>& triangles,
               const std::shared_ptr<const TriangleTree>& tree) {
  const MeshMeasures m = measure_mesh(triangles);
  Solid solid;
  solid.volume = m.volume;
  solid.surface = m.surface;
  solid.centre = m.centre;
  solid.inertia = m.inertia;
  solid.box = m.box;
  for (const MeshPoint& point : mesh_points(triangles, outline_points))
    solid.points.push_back({point.position, m.surface / outline_points});
  solid.columns = [triangles](const ColumnGrid& grid) { return mesh_columns(grid, triangles); };
  solid.distance = [tree](const Vector3& p) { return norm(tree->nearest(p) - p); };
  solid.onto = [tree](const Vector3& p) { return tree->nearest(p); };
  return solid;
}

} // namespace

MeshClumps::MeshClumps(std::vector<Triangle3> closed_triangles)
    : triangles_(std::move(closed_triangles)),
      tree_(std::make_shared<const TriangleTree>(triangles_)), solid_(solid_of(triangles_, tree_)) {
  std::vector<Ball> balls;
  const double size = norm(solid_.box.upper - solid_.box.lower);
  for (const MeshPoint& point : mesh_points(triangles_, ball_candidates)) {
    const Ball ball = shrunken_ball(*tree_, point, size);
    if (ball.radius > 1e-6 * size)
      balls.push_back(ball);
  }
  Voxels voxels(solid_);
  balls_ = ordered_by_gain(balls, voxels);
  if (balls_.count() == 0)
    throw InputError("the surface holds no ball that reaches the middle of a voxel, of which there "
                     "are 512 along "
                     "the body at most; give a thicker body");
}

SphereSet MeshClumps::spheres(int count, SphereSpacing spacing) const {
  if (spacing != SphereSpacing::medial && spacing != SphereSpacing::minimax_volume)
    throw InputError("spacing " + word_of(spacing) +
                     " is for ellipsoids; a clump from a surface needs medial or minimax_volume");
  if (count < 1 || count > largest_count())
    throw InputError(fmt::format("{} spheres; allowed are 1 to {}, of which each adds some volume: "
                                 "choose a number in this range",
                                 count, largest_count()));
  SphereSet set = balls_;
  set.centres.resize(static_cast<std::size_t>(count));
  set.radii.resize(static_cast<std::size_t>(count));
  if (spacing == SphereSpacing::minimax_volume) {
    const double growth = best_growth(set, solid_);
    for (double& radius : set.radii)
      radius += growth;
  }
  return set;
}

int MeshClumps::count_for(double tolerance, SphereSpacing spacing) const {
  const auto is_enough = [&](int count, int columns) {
    return share_in_exactly_one(spheres(count, spacing), solid_, columns) <= tolerance;
  };
  int low = 0, high = 1;
  while (high < largest_count() && !is_enough(high, search_columns)) {
    low = high;
    high = std::min(2 * high, largest_count());
  }
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (is_enough(middle, search_columns) ? high : low) = middle;
  }
  while (high < largest_count() && !is_enough(high, comparison_columns))
    ++high;
  if (!is_enough(high, comparison_columns))
    throw InputError(fmt::format("no number of spheres up to {} comes within {:g} of the volume: "
                                 "allow a larger tolerance",
                                 largest_count(), tolerance));
  return high;
}

} // namespace ellipsoid::post
