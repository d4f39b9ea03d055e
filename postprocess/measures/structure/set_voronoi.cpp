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
  std::vector<Vector3> in_bodies;  ///< the same points, of bodies that no face has taken apart
  std::vector<std::size_t> owners; ///< particle of each point
  double least_room = 0.0; ///< a quarter of the distance of a point from its images, or less
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
  seeds.least_room = 0.25 * std::min({cell.thickness(0), cell.thickness(1), cell.thickness(2)});
  for (std::size_t i = 0; i < set.particles.size(); ++i) {
    const Particle& p = set.particles[i];
    const std::vector<Vector3> points =
        by_centre ? std::vector<Vector3>{p.centre}
                  : surface_points_of(set, p, depth, options.spacing * mean_radius);
    std::size_t inside = 0;
    for (const Vector3& point : points)
      if (lies_inside(cell, point)) {
        seeds.points.push_back(cell.wrapped(point) - cell.corner());
        seeds.in_bodies.push_back(point);
        seeds.owners.push_back(i);
        ++inside;
      }
    if (inside == 0)
      throw InputError(fmt::format("particle {} at {} {} {} lies outside the box: give --box", p.id,
                                   p.centre.x, p.centre.y, p.centre.z));
  }
  return seeds;
}

/// Faces of one point's cell.
struct CellFaces {
  explicit CellFaces(voro::voronoicell_neighbor& cell) {
    cell.neighbors(neighbours);
    cell.face_areas(areas);
    cell.normals(normals);
    cell.face_vertices(corners_of_faces);
    cell.vertices(corners);
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      first_corners.push_back(static_cast<std::size_t>(corners_of_faces[at_ + 1]));
      at_ += static_cast<std::size_t>(corners_of_faces[at_]) + 1;
    }
  }

  Vector3 normal(std::size_t k) const {
    return {normals[3 * k], normals[3 * k + 1], normals[3 * k + 2]};
  }
  /// From the point to that on the other side of the face.
  Vector3 way_across(std::size_t k) const {
    const std::size_t c = 3 * first_corners[k];
    return 2.0 * dot(normal(k), {corners[c], corners[c + 1], corners[c + 2]}) * normal(k);
  }

  std::vector<int> neighbours;
  std::vector<double> areas, normals, corners; ///< corners relative to the point
  std::vector<int> corners_of_faces;
  std::vector<std::size_t> first_corners;

 private:
  std::size_t at_ = 0;
};

/// Whether a face lies between two points of one body, not between a body and an image of itself.
bool is_in_body(const CellFaces& faces, std::size_t k, const Seeds& seeds, std::size_t point) {
  const Vector3 way =
      seeds.in_bodies[static_cast<std::size_t>(faces.neighbours[k])] - seeds.in_bodies[point];
  return norm(faces.way_across(k) - way) < seeds.least_room; // normals of slivers are not exact
}

void add_cell(CellSums& sums, voro::voronoicell_neighbor& cell, std::size_t point,
              const Seeds& seeds) {
  sums.volume += cell.volume();
  const std::size_t owner = seeds.owners[point];
  const CellFaces faces(cell);
  for (std::size_t k = 0; k < faces.neighbours.size(); ++k) {
    const bool is_wall = faces.neighbours[k] < 0;
    const std::size_t other =
        is_wall ? owner : seeds.owners[static_cast<std::size_t>(faces.neighbours[k])];
    if (!is_wall && other == owner && is_in_body(faces, k, seeds, point))
      continue;
    const Vector3 normal = faces.normal(k);
    const Eigen::Vector3d n(normal.x, normal.y, normal.z);
    sums.area += faces.areas[k];
    sums.normals += faces.areas[k] * n * n.transpose();
    if (is_wall)
      sums.is_bounded_by_box = true;
    else if (other != owner)
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
      const auto point = static_cast<std::size_t>(loop.pid());
      add_cell(sums[seeds.owners[point]], cell, point, seeds);
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
  for (std::vector<Vector3>* points : {&seeds.points, &seeds.in_bodies})
    for (Vector3& point : *points)
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

/// The sums of each particle's cell, with the mean distance of the points as the unit of length:
/// voro++ takes 1e-11 for nothing, whatever the unit.
std::vector<CellSums> sums_of(Seeds seeds, const PeriodicCell& cell, std::size_t count) {
  const double unit = std::cbrt(cell.volume() / static_cast<double>(seeds.points.size()));
  const double scale = 1.0 / unit;
  for (std::vector<Vector3>* points : {&seeds.points, &seeds.in_bodies})
    for (Vector3& point : *points)
      point = scale * point;
  seeds.least_room *= scale;
  const PeriodicCell scaled(scale * cell.corner(),
                            {scale * cell.edge(0), scale * cell.edge(1), scale * cell.edge(2)},
                            {cell.is_periodic(0), cell.is_periodic(1), cell.is_periodic(2)});
  std::vector<CellSums> sums = has_own_axes(cell) ? sums_in_tilted_box(seeds, scaled, count)
                                                  : sums_in_box(seeds, scaled, count);
  for (CellSums& one : sums) {
    one.volume *= unit * unit * unit;
    one.area *= unit * unit;
    one.normals *= unit * unit;
  }
  return sums;
}

} // namespace

std::vector<SetVoronoiCell> set_voronoi(const ParticleSet& set, const PeriodicCell& cell,
                                        const SetVoronoiOptions& options) {
  if (set.particles.empty())
    throw InputError("there are no particles");
  check(cell);
  const Seeds seeds = seeds_of(set, cell, options);
  const std::size_t count = set.particles.size();
  const std::vector<CellSums> sums = sums_of(seeds, cell, count);
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
