// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Set-Voronoi cells against closed forms and against random points that look for their nearest
// surface.
#include "ellipsoid/ellipsoid_contact.h"
#include "set_voronoi.h"
#include "surface_sampling.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

PeriodicCell box(double x, double y, double z, bool repeats = true) {
  return PeriodicCell({-0.2, 0.1, 0.3},
                      {Vector3{x, 0.0, 0.0}, Vector3{0.0, y, 0.0}, Vector3{0.0, 0.0, z}},
                      {repeats, repeats, repeats});
}

Particle body(const Vector3& centre, const Vector3& semiaxes, const Quaternion& q = {}) {
  Particle p;
  p.centre = centre;
  p.semiaxes = semiaxes;
  p.orientation = q;
  return p;
}

/// Distance of a point from a body, by the kernel's search with a tiny ball.
double distance(const ParticleSet& set, const Particle& p, const Vector3& way) {
  if (p.is_smooth()) {
    constexpr double tiny = 1.0e-5;
    SearchOptions exact;
    exact.goal = SearchGoal::distance;
    return -find_contact(make_shape(p.semiaxes, p.orientation), make_shape({tiny, tiny, tiny}, {}),
                         way, exact)
                .overlap;
  }
  double nearest = 1e9;
  for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k)
    nearest =
        std::min(nearest, norm(way - (set.spheres[k].centre - p.centre)) - set.spheres[k].radius);
  return nearest;
}

double total_volume(const std::vector<SetVoronoiCell>& cells) {
  double sum = 0.0;
  for (const SetVoronoiCell& c : cells)
    sum += c.volume;
  return sum;
}

TEST(SurfaceSampling, points_lie_at_the_depth_below_the_surface) {
  ParticleSet set;
  set.particles = {
      body({0.3, 0.2, 0.1}, {0.5, 0.3, 0.2}, normalized(Quaternion{0.3, 0.5, -0.4, 0.7}))};
  const Particle& p = set.particles[0];
  const auto points = surface_points_of(set, p, 0.01, 0.05);
  EXPECT_GT(points.size(), 500u);
  for (const Vector3& point : points) {
    const Vector3 b = rotation(p.orientation).to_body(point - p.centre);
    const double level = b.x * b.x / 0.25 + b.y * b.y / 0.09 + b.z * b.z / 0.04;
    EXPECT_LT(level, 1.0);
    const Vector3 gradient{b.x / 0.25, b.y / 0.09, b.z / 0.04}; // distance ~ (1 - level) / 2 |g|
    EXPECT_NEAR((1.0 - level) / (2.0 * norm(gradient)), 0.01, 1.5e-3);
  }
}

TEST(SetVoronoi, equal_spheres_have_ordinary_cells) {
  // face-centred cubic: rhombic dodecahedra with 12 neighbours and solid fraction pi / sqrt(18)
  ParticleSet set;
  const double edge = 1.0, r = edge * std::sqrt(0.125);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k)
        if ((i + j + k) % 2 == 0)
          set.particles.push_back(
              body({0.5 * edge * i, 0.5 * edge * j, 0.5 * edge * k}, {r, r, r}));
  const auto cells = set_voronoi(set, box(2.0 * edge, 2.0 * edge, 2.0 * edge), {});
  ASSERT_EQ(cells.size(), 32u);
  for (const SetVoronoiCell& c : cells) {
    EXPECT_NEAR(c.packing_fraction, pi / std::sqrt(18.0), 1e-9);
    EXPECT_GE(c.neighbours, 12u); // rounding may add corners of four cells
    EXPECT_NEAR(c.anisotropy, 1.0, 1e-9);
    EXPECT_FALSE(c.is_bounded_by_box);
    // surface of a rhombic dodecahedron with inscribed radius r: 12 sqrt(2) r^2
    EXPECT_NEAR(c.area, 12.0 * std::sqrt(2.0) * r * r, 1e-9);
  }
}

TEST(SetVoronoi, ellipsoids_on_a_lattice_share_the_box) {
  ParticleSet set;
  const Vector3 s{0.3, 0.15, 0.2};
  for (int n = 0; n < 27; ++n)
    set.particles.push_back(body({0.7 * (n % 3), 0.4 * (n / 3 % 3), 0.5 * (n / 9)}, s));
  const PeriodicCell cell = box(2.1, 1.2, 1.5);
  const auto cells = set_voronoi(set, cell, {});
  EXPECT_NEAR(total_volume(cells), cell.volume(), 1e-9 * cell.volume());
  for (const SetVoronoiCell& c : cells) {
    EXPECT_NEAR(c.packing_fraction, 4.0 / 3.0 * pi * 0.3 * 0.15 * 0.2 / (0.7 * 0.4 * 0.5), 1e-4);
    EXPECT_GE(c.neighbours, 6u);
  }
  // a box of 0.7 x 0.4 x 0.5: smallest over largest pair of faces, with finer points
  SetVoronoiOptions fine;
  fine.spacing = 0.1;
  const SetVoronoiCell one = set_voronoi(set, cell, fine).front();
  EXPECT_NEAR(one.anisotropy, (0.4 * 0.5) / (0.7 * 0.5), 0.01);
  EXPECT_NEAR(one.area / (2.0 * (0.7 * 0.4 + 0.7 * 0.5 + 0.4 * 0.5)), 1.0, 0.01);
}

/// Largest difference of a cell of a lattice from its mean cell (1).
double unevenness(double unit) {
  ParticleSet set;
  const Vector3 s{0.4 * unit, 0.3 * unit, 0.25 * unit};
  for (int n = 0; n < 27; ++n)
    set.particles.push_back(body({unit * (n % 3), unit * (n / 3 % 3), unit * (n / 9)}, s));
  const double edge = 3.0 * unit, volume = unit * unit * unit;
  SetVoronoiOptions fine;
  fine.spacing = 0.15;
  double largest = 0.0;
  for (const SetVoronoiCell& c : set_voronoi(set, box(edge, edge, edge), fine))
    largest = std::max(largest, std::abs(c.volume / volume - 1.0));
  return largest;
}

TEST(SetVoronoi, cells_do_not_depend_on_the_unit_of_length) {
  for (const double unit : {1.0, 1e-3, 1e-6})
    EXPECT_LT(unevenness(unit), 1e-9) << unit;
}

/// Shares of the box by random points: each belongs to the nearest surface.
void expect_shares(const ParticleSet& set, const PeriodicCell& cell,
                   const std::vector<SetVoronoiCell>& cells) {
  constexpr int trials = 40000;
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<double> hits(set.particles.size(), 0.0);
  for (int trial = 0; trial < trials; ++trial) {
    const Vector3 point = cell.corner() + share(generator) * cell.edge(0) +
                          share(generator) * cell.edge(1) + share(generator) * cell.edge(2);
    std::size_t nearest = 0;
    double least = 1e9;
    for (std::size_t i = 0; i < set.particles.size(); ++i) {
      const Vector3 way = cell.nearest(point - set.particles[i].centre);
      const double d = distance(set, set.particles[i], way);
      if (d < least) {
        least = d;
        nearest = i;
      }
    }
    hits[nearest] += 1.0;
  }
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const double p = hits[i] / trials;
    const double error = std::sqrt(p * (1.0 - p) / trials);
    // and of the points on the surfaces: 1 % of a cell
    EXPECT_NEAR(cells[i].volume / cell.volume(), p, 4.0 * error + 0.01 * p) << i;
  }
}

TEST(SetVoronoi, mixed_bodies_get_the_points_that_are_nearest) {
  std::mt19937 generator(9);
  std::normal_distribution<double> normal;
  const auto turn = [&] {
    return normalized(
        Quaternion{normal(generator), normal(generator), normal(generator), normal(generator)});
  };
  ParticleSet set;
  const Vector3 axes[] = {{0.30, 0.12, 0.18}, {0.10, 0.25, 0.25}, {0.2, 0.2, 0.2}};
  for (int n = 0; n < 8; ++n)
    set.particles.push_back(
        body({0.65 * (n % 2), 0.65 * (n / 2 % 2), 0.65 * (n / 4)}, axes[n % 3], turn()));
  // a bent body of three spheres instead of the first one
  Particle& bent = set.particles[0];
  bent.first_sphere = 0;
  bent.sphere_count = 3;
  set.spheres = {{bent.centre, 0.12},
                 {bent.centre + Vector3{0.12, 0.0, 0.0}, 0.1},
                 {bent.centre + Vector3{0.0, 0.14, 0.0}, 0.1}};
  const PeriodicCell cell = box(1.3, 1.3, 1.3);
  const auto cells = set_voronoi(set, cell, {});
  EXPECT_NEAR(total_volume(cells), cell.volume(), 1e-9 * cell.volume());
  expect_shares(set, cell, cells);
  const PeriodicCell tilted(
      {-0.2, 0.1, 0.3}, {Vector3{1.3, 0.0, 0.0}, Vector3{0.3, 1.3, 0.0}, Vector3{-0.2, 0.4, 1.3}},
      {true, true, true});
  const auto in_tilted = set_voronoi(set, tilted, {});
  EXPECT_NEAR(total_volume(in_tilted), tilted.volume(), 1e-9 * tilted.volume());
  expect_shares(set, tilted, in_tilted);
}

TEST(SetVoronoi, cells_end_at_the_box) {
  ParticleSet set;
  set.particles = {body({0.3, 0.6, 0.8}, {0.2, 0.1, 0.1}), body({1.1, 0.6, 0.8}, {0.1, 0.1, 0.1})};
  const auto cells = set_voronoi(set, box(2.0, 1.0, 1.0, false), {});
  EXPECT_NEAR(cells[0].volume + cells[1].volume, 2.0, 1e-9);
  EXPECT_TRUE(cells[0].is_bounded_by_box && cells[1].is_bounded_by_box);
  EXPECT_EQ(cells[0].neighbours, 1u);
  set.particles[1].centre.x = 9.0;
  EXPECT_THROW(set_voronoi(set, box(2.0, 1.0, 1.0, false), {}), InputError);
  const PeriodicCell half_open(
      {}, {Vector3{2.0, 0.0, 0.0}, Vector3{0.3, 1.0, 0.0}, Vector3{0.0, 0.0, 1.0}},
      {true, true, false});
  EXPECT_THROW(set_voronoi(set, half_open, {}), InputError);
}

} // namespace
} // namespace ellipsoid::post
