// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Measures of synthetic piles whose answers are known.
#include "coordination.h"
#include "porosity.h"
#include "repose.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

Particle plane_particle(double a, double b, double x, double y, double angle = 0.0) {
  Particle p;
  p.semiaxes = {a, b, b};
  p.centre = {x, y, 0.0};
  p.orientation = {std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle)};
  return p;
}

void number(ParticleSet& set) {
  for (std::size_t k = 0; k < set.particles.size(); ++k)
    set.particles[k].id = static_cast<std::int64_t>(k) + 1;
}

std::vector<std::size_t> all_of(const ParticleSet& set) {
  std::vector<std::size_t> members(set.particles.size());
  for (std::size_t k = 0; k < members.size(); ++k)
    members[k] = k;
  return members;
}

/// Discs of radius r with centres on a line that falls by `degrees`, r / 10 apart, so that the
/// surface waves by less than r / 800; the line passes through (0, height).
ParticleSet slope(double degrees, double height, double r) {
  ParticleSet set;
  const double c = std::cos(degrees * pi / 180.0), s = std::sin(degrees * pi / 180.0);
  for (double along = 0.0; height - along * s > r; along += 0.1 * r)
    set.particles.push_back(plane_particle(r, r, along * c, height - along * s));
  number(set);
  return set;
}

TEST(Repose, a_heap_cut_at_25_degrees) {
  for (const double degrees : {5.0, 25.0, 40.0}) {
    const ParticleSet set = slope(degrees, 1.0, 0.004);
    const PileOptions options;
    const Pile pile = find_pile(set, options);
    const ReposeAngle angle = repose_angle(pile, options, Flank::right);
    // the surface waves by amp = r / 800 with a period of r / 10: the slope of the fit over a
    // length of 0.6 is off by less than 6 amp / 0.6 per period counted, 1e-7 rad
    EXPECT_NEAR(angle.angle_deg, degrees, 1e-5);
    EXPECT_LT(angle.residual_in_b, 1.0 / 800.0);
    EXPECT_NEAR(angle.a.y() / pile.surface.summit().y(), 0.8, 0.01);
    EXPECT_NEAR(angle.b.y() / pile.surface.summit().y(), 0.2, 0.01);
  }
}

TEST(Repose, particles_that_rolled_away_change_nothing) {
  const PileOptions options;
  ParticleSet set = slope(25.0, 0.5, 0.004);
  const double alone = repose_angle(find_pile(set, options), options, Flank::right).angle_deg;
  for (double x = 1.5; x < 3.0; x += 0.1)
    set.particles.push_back(plane_particle(0.004, 0.004, x, 0.004));
  number(set);
  const Pile pile = find_pile(set, options);
  EXPECT_EQ(pile.strays, 15u);
  EXPECT_EQ(repose_angle(pile, options, Flank::right).angle_deg, alone);
}

TEST(Repose, a_heap_beyond_the_toe_changes_nothing) {
  const PileOptions options;
  ParticleSet set = slope(25.0, 0.5, 0.004);
  const Pile slope_alone = find_pile(set, options);
  const double alone = repose_angle(slope_alone, options, Flank::right).angle_deg;
  for (double x = 1.06; x < 1.6; x += 0.007) // a chain on the floor, and a tower on it
    set.particles.push_back(plane_particle(0.004, 0.004, x, 0.004));
  for (double y = 0.01; y < 0.2; y += 0.007)
    set.particles.push_back(plane_particle(0.004, 0.004, 1.4, y));
  number(set);
  const Pile pile = find_pile(set, options);
  EXPECT_EQ(pile.strays, 0u);
  for (double x = 0.0; x < 1.0; x += 1.0e-3)
    EXPECT_EQ(pile.surface.height(x), slope_alone.surface.height(x)) << x;
  // the columns' spacing is a share of the mean b, whose sum is rounded otherwise
  EXPECT_DOUBLE_EQ(repose_angle(pile, options, Flank::right).angle_deg, alone);
}

TEST(Repose, both_flanks_of_a_free_pile) {
  ParticleSet set = slope(30.0, 0.5, 0.004), left = slope(20.0, 0.5, 0.004);
  for (Particle p : left.particles) {
    p.centre.x = -p.centre.x;
    set.particles.push_back(p);
  }
  number(set);
  PileOptions options;
  options.wall.reset();
  const Pile pile = find_pile(set, options);
  EXPECT_NEAR(repose_angle(pile, options, Flank::right).angle_deg, 30.0, 1e-4);
  EXPECT_NEAR(repose_angle(pile, options, Flank::left).angle_deg, 20.0, 1e-4);
}

TEST(Repose, a_pile_of_one_particle_is_an_error) {
  ParticleSet set;
  set.particles = {plane_particle(2.0, 1.0, 2.0, 1.0)};
  PileOptions options;
  options.column_spacing = 1.0;
  options.cut_top = options.cut_bottom = 0.5;
  EXPECT_THROW(repose_angle(find_pile(set, options), options, Flank::right), InputError);
  EXPECT_THROW(find_pile(ParticleSet(), options), InputError);
}

/// Rows of touching ellipses with their axes along x and y, on the floor and at the wall.
ParticleSet lattice(int columns, int rows, double a, double b) {
  ParticleSet set;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      set.particles.push_back(plane_particle(a, b, a * (1.0 + 2.0 * i), b * (1.0 + 2.0 * j), 0.0));
  number(set);
  return set;
}

TEST(Porosity, of_a_lattice_of_ellipses_is_exact) {
  const double a = 2.7e-3, b = 1.15e-3;
  const int columns = 30, rows = 20;
  const ParticleSet set = lattice(columns, rows, a, b);
  const PileOptions options;
  const Porosity p = plane_porosity(find_pile(set, options), options, {}, {});
  // the free surface: straight up to the top row's centres, then half ellipses
  const double total = 2.0 * a * columns * b * (2.0 * rows - 1.0) + 0.5 * pi * a * b * columns;
  const double solid = pi * a * b * columns * rows;
  EXPECT_NEAR(p.total_area, total, 1e-12 * total);
  EXPECT_NEAR(p.solid_area, solid, 1e-12 * solid);
  EXPECT_NEAR(p.porosity, 1.0 - solid / total, 1e-12);
  EXPECT_NEAR(p.overlap_share, 0.0, 1e-12);
}

TEST(Porosity, of_multispheres_uses_the_cut_off_spheres_or_the_ellipse) {
  const double a = 2.7e-3, b = 1.15e-3;
  ParticleSet set = lattice(6, 5, a, b);
  const MultisphereTemplate chain = make_multisphere(a, b, 9);
  for (Particle& p : set.particles) {
    p.first_sphere = set.spheres.size();
    p.sphere_count = chain.centres.size();
    for (std::size_t k = 0; k < chain.centres.size(); ++k)
      set.spheres.push_back({p.centre + Vector3{chain.centres[k], 0.0, 0.0}, chain.radii[k]});
  }
  PileOptions options;
  const Porosity ms = plane_porosity(find_pile(set, options), options, {}, {});
  EXPECT_NEAR(ms.solid_area, 30.0 * measure(chain).area, 1e-12 * ms.solid_area);
  options.outline = OutlineKind::smooth_ellipse;
  const Porosity ellipse = plane_porosity(find_pile(set, options), options, {}, {});
  EXPECT_NEAR(ellipse.solid_area, 30.0 * pi * a * b, 1e-12 * ellipse.solid_area);
}

TEST(Porosity, overlaps_count_once) {
  const double a = 2.7e-3, b = 1.15e-3, squeeze = 0.98;
  ParticleSet set = lattice(10, 10, a, b);
  for (Particle& p : set.particles)
    p.centre.y = b + squeeze * (p.centre.y - b);
  const PileOptions options;
  const Porosity p = plane_porosity(find_pile(set, options), options, {}, {});
  // lens of two unit discs at distance 2 squeeze, times a b (affine map)
  const double lens = 2.0 * std::acos(squeeze) - 2.0 * squeeze * std::sqrt(1.0 - squeeze * squeeze);
  const double lenses = 90.0 * lens * a * b, sum = 100.0 * pi * a * b;
  EXPECT_NEAR(p.area_sum, sum, 1e-12 * sum);
  EXPECT_NEAR(p.solid_area, sum - lenses, 1e-11 * sum);
}

TEST(Porosity, core_region_against_counting_points) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  ParticleSet set;
  for (double x = 0.01; x < 2.4; x += 0.05) // a wedge of 22 degrees of turned, jumbled ellipses
    for (double y = 0.03; y < 1.0 - 0.404 * x; y += 0.05)
      set.particles.push_back(plane_particle(0.05, 0.02, x + 0.01 * uniform(generator),
                                             y + 0.01 * uniform(generator),
                                             pi * uniform(generator)));
  number(set);
  const PileOptions options;
  const Pile pile = find_pile(set, options);
  const ReposeAngle angle = repose_angle(pile, options, Flank::right);
  PorosityOptions core;
  core.region = PorosityRegion::core;
  const Porosity exact = plane_porosity(pile, options, core, {angle});
  const double margin = core.margin * 0.05, slope = angle.line.slope;
  long inside = 0, solid = 0;
  constexpr double step = 0.001;
  for (double x = margin + 0.5 * step; x < pile.right; x += step)
    for (double y = margin + 0.5 * step; y < 1.0; y += step) {
      if (y > angle.line.intercept + slope * x - margin * std::hypot(1.0, slope))
        break;
      ++inside;
      solid += std::any_of(pile.outlines.begin(), pile.outlines.end(), [&](const auto& e) {
        return std::abs(e.centre.x() - x) < 0.05 && e.level({x, y}) < 0.0;
      });
    }
  const double counted = 1.0 - static_cast<double>(solid) / static_cast<double>(inside);
  // points within half a step of a boundary are uncertain: 2e-4 of the area as random signs
  EXPECT_NEAR(exact.porosity, counted, 1e-3);
  EXPECT_NEAR(exact.total_area, step * step * static_cast<double>(inside), 2e-3 * exact.total_area);
}

/// A hexagonal lattice of discs of radius 1 at distance `spacing`, stretched by `stretch` along x
/// and turned by `angle`: touching is kept by the stretch.
ParticleSet hexagonal(int columns, int rows, double spacing, double stretch, double angle) {
  ParticleSet set;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = stretch * spacing * (i + 0.5 * (j % 2));
      const double y = spacing * std::sqrt(0.75) * j;
      set.particles.push_back(plane_particle(stretch, 1.0,
                                             x * std::cos(angle) - y * std::sin(angle),
                                             x * std::sin(angle) + y * std::cos(angle), angle));
    }
  number(set);
  return set;
}

TEST(Coordination, of_a_known_network) {
  const int columns = 12, rows = 9;
  // within rows, and two partners in the next row but at its end
  const std::size_t pairs = rows * (columns - 1) + (rows - 1) * (2 * columns - 1);
  for (const double stretch : {1.0, 2.35, 10.0})
    for (const double angle : {0.0, 0.5, 2.0}) {
      const ParticleSet touching = hexagonal(columns, rows, 1.999, stretch, angle);
      CoordinationOptions options;
      const Coordination z = coordination(touching, all_of(touching), options);
      EXPECT_EQ(z.pairs, pairs) << stretch << " " << angle;
      EXPECT_DOUBLE_EQ(z.zpp, 2.0 * static_cast<double>(pairs) / (columns * rows));
      EXPECT_EQ(z.zss, z.zpp);
      EXPECT_EQ(z.distribution[6], static_cast<std::size_t>((columns - 2) * (rows - 2)));
      EXPECT_EQ(z.not_converged, 0u);
      const ParticleSet apart = hexagonal(columns, rows, 2.0001, stretch, angle);
      EXPECT_EQ(coordination(apart, all_of(apart), options).pairs, 0u);
      if (stretch == 1.0) {
        EXPECT_NEAR(z.largest_overlap, 0.001, 1e-12);
        EXPECT_NEAR(z.mean_overlap, 0.001, 1e-12);
        options.gap = 0.00011;
        EXPECT_EQ(coordination(apart, all_of(apart), options).pairs, pairs);
      }
    }
}

TEST(Coordination, walls_and_rattlers) {
  ParticleSet set = lattice(3, 2, 1.0, 0.5);
  for (Particle& p : set.particles) // overlaps of 0.1 % along both axes
    p.centre = {0.999 * p.centre.x, 0.999 * p.centre.y, 0.0};
  set.particles.push_back(plane_particle(1.0, 0.5, 20.0, 3.0)); // touches nothing
  number(set);
  CoordinationOptions options;
  options.walls = {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}};
  Coordination z = coordination(set, all_of(set), options);
  EXPECT_EQ(z.pairs, 7u);
  EXPECT_EQ(z.wall_contacts, 5u); // two at the wall, three on the floor
  EXPECT_EQ(z.rattlers, 1u);
  EXPECT_DOUBLE_EQ(z.zpp, 14.0 / 7.0);
  EXPECT_DOUBLE_EQ(z.zpp_without_rattlers, 14.0 / 6.0);
  options.count_walls = true;
  z = coordination(set, all_of(set), options);
  EXPECT_DOUBLE_EQ(z.zpp, 19.0 / 7.0);
}

TEST(Coordination, sphere_sphere_contacts_of_two_chains_side_by_side) {
  ParticleSet set;
  const MultisphereTemplate chain = make_multisphere(2.7, 1.15, 5);
  for (int k = 0; k < 2; ++k) { // only the largest spheres and, pairwise equal, no others touch
    Particle p = plane_particle(2.7, 1.15, 0.0, k * 2.0 * 1.011 * 1.0);
    p.first_sphere = set.spheres.size();
    p.sphere_count = 5;
    for (std::size_t s = 0; s < 5; ++s)
      set.spheres.push_back({p.centre + Vector3{chain.centres[s], 0.0, 0.0}, chain.radii[s]});
    set.particles.push_back(p);
  }
  number(set);
  // brute force over all pairs of spheres
  std::size_t expected = 0;
  for (std::size_t s = 0; s < 5; ++s)
    for (std::size_t t = 5; t < 10; ++t)
      expected += norm(set.spheres[s].centre - set.spheres[t].centre) <=
                  set.spheres[s].radius + set.spheres[t].radius;
  const Coordination z = coordination(set, all_of(set), {});
  EXPECT_GT(expected, 1u);
  EXPECT_EQ(z.contacts, expected);
  EXPECT_EQ(z.pairs, 1u);
  EXPECT_DOUBLE_EQ(z.zss, static_cast<double>(expected));
  EXPECT_DOUBLE_EQ(z.zpp, 1.0);
}

} // namespace
} // namespace ellipsoid::post
