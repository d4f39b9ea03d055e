// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "set_voronoi.h"

#include "body_properties.h"
#include "surface_sampling.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <voro++.hh>

namespace ellipsoid::post {
namespace {

/// Points that stand for the particles, relative to the corner of the box.
struct Seeds {
  std::vector<Vector3> points;
  std::vector<std::size_t> owners; ///< particle of each point
};

/// What the cells of one particle's points sum up to.
struct CellSums {
  double volume = 0.0, area = 0.0;
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero(); ///< integral of n n over the surface
  std::set<std::size_t> neighbours;
  bool is_bounded_by_box = false;
};

bool are_equal_spheres(const ParticleSet& set) {
  constexpr double rounding = 1.0e-9;
  const double radius = set.particles.front().largest_axis();
  return std::all_of(set.particles.begin(), set.particles.end(), [&](const Particle& p) {
    return p.is_smooth() && p.largest_axis() <= (1.0 + rounding) * radius &&
           p.smallest_axis() >= (1.0 - rounding) * radius;
  });
}

bool lies_inside(const PeriodicCell& cell, const Vector3& point) {
  const Vector3 f = cell.fractions(point);
  const double shares[3] = {f.x, f.y, f.z};
  for (std::size_t k = 0; k < 3; ++k)
    if (!cell.is_periodic(k) && !(shares[k] > 0.0 && shares[k] < 1.0))
      return false;
  return true;
}

/// Points a little below the surfaces: the same cells, and bodies that overlap stay apart.
Seeds seeds_of(const ParticleSet& set, const PeriodicCell& cell, const SetVoronoiOptions& options) {
  constexpr double depth_of_points = 0.05; // of the smallest radius of curvature
  const bool by_centre = are_equal_spheres(set);
  double depth = set.particles.front().largest_axis(), mean_radius = 0.0;
  for (const Particle& p : set.particles) {
    depth = std::min(depth, depth_of_points * smallest_curvature_radius(set, p));
    mean_radius += volume_radius(body_volume(set, p)) / static_cast<double>(set.particles.size());
  }
  Seeds seeds;
  for (std::size_t i = 0; i < set.particles.size(); ++i) {
    const Particle& p = set.particles[i];
    const std::vector<Vector3> points =
        by_centre ? std::vector<Vector3>{p.centre}
                  : surface_points_of(set, p, depth, options.spacing * mean_radius);
    std::size_t inside = 0;
    for (const Vector3& point : points)
      if (lies_inside(cell, point)) {
        seeds.points.push_back(cell.wrapped(point) - cell.corner());
        seeds.owners.push_back(i);
        ++inside;
      }
    if (inside == 0)
      throw InputError(fmt::format("particle {} at {} {} {} lies outside the box: give --box", p.id,
                                   p.centre.x, p.centre.y, p.centre.z));
  }
  return seeds;
}

void add_cell(CellSums& sums, voro::voronoicell_neighbor& cell, std::size_t owner,
              const std::vector<std::size_t>& owners) {
  sums.volume += cell.volume();
  std::vector<int> neighbours;
  std::vector<double> areas, normals;
  cell.neighbors(neighbours);
  cell.face_areas(areas);
  cell.normals(normals);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    const bool is_wall = neighbours[k] < 0;
    const std::size_t other = is_wall ? owner : owners[static_cast<std::size_t>(neighbours[k])];
    if (!is_wall && other == owner)
      continue; // between points of the same particle
    const Eigen::Vector3d n(normals[3 * k], normals[3 * k + 1], normals[3 * k + 2]);
    sums.area += areas[k];
    sums.normals += areas[k] * n * n.transpose();
    if (is_wall)
      sums.is_bounded_by_box = true;
    else
      sums.neighbours.insert(other);
  }
}

/// Runs voro++ over a container that is filled already.
template <class Container, class Loop>
std::vector<CellSums> cell_sums(Container& container, Loop loop, const Seeds& seeds,
                                std::size_t count) {
  std::vector<CellSums> sums(count);
  voro::voronoicell_neighbor cell;
  if (loop.start())
    do {
      if (!container.compute_cell(cell, loop))
        continue;
      const std::size_t owner = seeds.owners[static_cast<std::size_t>(loop.pid())];
      add_cell(sums[owner], cell, owner, seeds.owners);
    } while (loop.inc());
  return sums;
}

/// Numbers of blocks along the edges, so that a block has a few points.
std::array<int, 3> blocks_for(const PeriodicCell& cell, std::size_t points) {
  constexpr double per_block = 6.0;
  const double size = std::cbrt(cell.volume() * per_block / static_cast<double>(points));
  std::array<int, 3> blocks;
  for (std::size_t k = 0; k < 3; ++k)
    blocks[k] = std::clamp(static_cast<int>(cell.thickness(k) / size), 1, 500);
  return blocks;
}

constexpr int first_memory = 8; // points a block is made for

template <class Container> void fill(Container& container, const Seeds& seeds) {
  for (std::size_t n = 0; n < seeds.points.size(); ++n)
    container.put(static_cast<int>(n), seeds.points[n].x, seeds.points[n].y, seeds.points[n].z);
}

std::vector<CellSums> sums_in_box(const Seeds& seeds, const PeriodicCell& cell, std::size_t count) {
  const std::array<int, 3> n = blocks_for(cell, seeds.points.size());
  voro::container container(0.0, cell.edge(0).x, 0.0, cell.edge(1).y, 0.0, cell.edge(2).z, n[0],
                            n[1], n[2], cell.is_periodic(0), cell.is_periodic(1),
                            cell.is_periodic(2), first_memory);
  fill(container, seeds);
  return cell_sums(container, voro::c_loop_all(container), seeds, count);
}

/// Axes in which the first edge lies along x and the second one in the plane of x and y.
Rotation3 axes_of_edges(const PeriodicCell& cell) {
  const Vector3 x = normalized(cell.edge(0)), z = normalized(cross(cell.edge(0), cell.edge(1)));
  return {x, cross(z, x), z};
}

std::vector<CellSums> sums_in_tilted_box(Seeds seeds, const PeriodicCell& cell, std::size_t count) {
  const std::array<int, 3> n = blocks_for(cell, seeds.points.size());
  const Rotation3 axes = axes_of_edges(cell);
  const Vector3 a = axes.to_body(cell.edge(0)), b = axes.to_body(cell.edge(1)),
                c = axes.to_body(cell.edge(2));
  for (Vector3& point : seeds.points)
    point = axes.to_body(point);
  voro::container_periodic container(a.x, b.x, b.y, c.x, c.y, c.z, n[0], n[1], n[2], first_memory);
  fill(container, seeds);
  return cell_sums(container, voro::c_loop_all_periodic(container), seeds, count);
}

/// Cells fill the box: what does not is a fault of this program.
void require_whole_box(const std::vector<CellSums>& sums, const PeriodicCell& cell) {
  constexpr double rounding = 1.0e-6;
  double whole = 0.0;
  for (const CellSums& one : sums)
    whole += one.volume;
  if (!(std::abs(whole - cell.volume()) <= rounding * cell.volume()))
    throw InputError(fmt::format("internal error: the Voronoi cells have the volume {}, the box {}",
                                 whole, cell.volume()));
}

/// Whether edges are elsewhere than along x, y, z, in this order.
bool has_own_axes(const PeriodicCell& cell) {
  return cell.is_tilted() || cell.edge(0).x < 0.0 || cell.edge(1).y < 0.0 || cell.edge(2).z < 0.0;
}

void check(const PeriodicCell& cell) {
  const bool is_whole = cell.is_periodic(0) && cell.is_periodic(1) && cell.is_periodic(2);
  if (!(cell.volume() > 0.0))
    throw InputError("the box has no volume: give --box");
  if (has_own_axes(cell) && !is_whole)
    throw InputError("Voronoi cells in a tilted box need a box that is periodic along x, y and z");
}

} // namespace

std::vector<SetVoronoiCell> set_voronoi(const ParticleSet& set, const PeriodicCell& cell,
                                        const SetVoronoiOptions& options) {
  if (set.particles.empty())
    throw InputError("there are no particles");
  check(cell);
  const Seeds seeds = seeds_of(set, cell, options);
  const std::size_t count = set.particles.size();
  const std::vector<CellSums> sums =
      has_own_axes(cell) ? sums_in_tilted_box(seeds, cell, count) : sums_in_box(seeds, cell, count);
  require_whole_box(sums, cell);
  std::vector<SetVoronoiCell> cells;
  for (std::size_t i = 0; i < count; ++i) {
    SetVoronoiCell result;
    result.volume = sums[i].volume;
    result.area = sums[i].area;
    result.packing_fraction = body_volume(set, set.particles[i]) / sums[i].volume;
    result.neighbours = sums[i].neighbours.size();
    result.is_bounded_by_box = sums[i].is_bounded_by_box;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sums[i].normals,
                                                                Eigen::EigenvaluesOnly);
    result.anisotropy = solver.eigenvalues()(0) / solver.eigenvalues()(2);
    cells.push_back(result);
  }
  return cells;
}

} // namespace ellipsoid::post
