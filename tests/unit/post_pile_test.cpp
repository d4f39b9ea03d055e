// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Measures of synthetic piles whose answers are known.
#include "cell_grid.h"
#include "coordination.h"
#include "disjoint_sets.h"
#include "ellipsoid/ellipsoid_contact.h"
#include "outline_level.h"
#include "porosity.h"
#include "repose.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>

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

Pile pile_of(const ParticleSet& set, const PileOptions& options) {
  return find_pile(set, options, near_pairs(set, options));
}

Coordination coordination_of_all(const ParticleSet& set, const CoordinationOptions& options) {
  return coordination(set, all_of(set), find_contacts(set, options.gap), options);
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
    const Pile pile = pile_of(set, options);
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
  const double alone = repose_angle(pile_of(set, options), options, Flank::right).angle_deg;
  for (double x = 1.5; x < 3.0; x += 0.1)
    set.particles.push_back(plane_particle(0.004, 0.004, x, 0.004));
  number(set);
  const Pile pile = pile_of(set, options);
  EXPECT_EQ(pile.strays, 15u);
  EXPECT_EQ(repose_angle(pile, options, Flank::right).angle_deg, alone);
}

TEST(Repose, a_heap_beyond_the_toe_changes_nothing) {
  const PileOptions options;
  ParticleSet set = slope(25.0, 0.5, 0.004);
  const Pile slope_alone = pile_of(set, options);
  const double alone = repose_angle(slope_alone, options, Flank::right).angle_deg;
  for (double x = 1.06; x < 1.6; x += 0.007) // a chain on the floor, and a tower on it
    set.particles.push_back(plane_particle(0.004, 0.004, x, 0.004));
  for (double y = 0.01; y < 0.2; y += 0.007)
    set.particles.push_back(plane_particle(0.004, 0.004, 1.4, y));
  number(set);
  const Pile pile = pile_of(set, options);
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
  const Pile pile = pile_of(set, options);
  EXPECT_NEAR(repose_angle(pile, options, Flank::right).angle_deg, 30.0, 1e-4);
  EXPECT_NEAR(repose_angle(pile, options, Flank::left).angle_deg, 20.0, 1e-4);
}

TEST(Repose, a_pile_of_one_particle_is_an_error) {
  ParticleSet set;
  set.particles = {plane_particle(2.0, 1.0, 2.0, 1.0)};
  PileOptions options;
  options.column_spacing = 1.0;
  options.cut_top = options.cut_bottom = 0.5;
  EXPECT_THROW(repose_angle(pile_of(set, options), options, Flank::right), InputError);
  EXPECT_THROW(pile_of(ParticleSet(), options), InputError);
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
  const Porosity p = plane_porosity(pile_of(set, options), options, {}, {});
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
  const Porosity ms = plane_porosity(pile_of(set, options), options, {}, {});
  EXPECT_NEAR(ms.solid_area, 30.0 * measure(chain).area, 1e-12 * ms.solid_area);
  options.outline = OutlineKind::smooth_ellipse;
  const Porosity ellipse = plane_porosity(pile_of(set, options), options, {}, {});
  EXPECT_NEAR(ellipse.solid_area, 30.0 * pi * a * b, 1e-12 * ellipse.solid_area);
}

TEST(Porosity, overlaps_count_once) {
  const double a = 2.7e-3, b = 1.15e-3, squeeze = 0.98;
  ParticleSet set = lattice(10, 10, a, b);
  for (Particle& p : set.particles)
    p.centre.y = b + squeeze * (p.centre.y - b);
  const PileOptions options;
  const Porosity p = plane_porosity(pile_of(set, options), options, {}, {});
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
  const Pile pile = pile_of(set, options);
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
        return std::abs(e.centre.x() - x) < 0.05 && level(e, {x, y}) < 0.0;
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
      const Coordination z = coordination_of_all(touching, options);
      EXPECT_EQ(z.pairs, pairs) << stretch << " " << angle;
      EXPECT_DOUBLE_EQ(z.zpp, 2.0 * static_cast<double>(pairs) / (columns * rows));
      EXPECT_EQ(z.zss, z.zpp);
      EXPECT_EQ(z.distribution[6], static_cast<std::size_t>((columns - 2) * (rows - 2)));
      EXPECT_EQ(z.not_converged, 0u);
      const ParticleSet apart = hexagonal(columns, rows, 2.0001, stretch, angle);
      EXPECT_EQ(coordination_of_all(apart, options).pairs, 0u);
      if (stretch == 1.0) {
        EXPECT_NEAR(z.largest_overlap, 0.001, 1e-12);
        EXPECT_NEAR(z.mean_overlap, 0.001, 1e-12);
        options.gap = 0.00011;
        EXPECT_EQ(coordination_of_all(apart, options).pairs, pairs);
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
  options.walls = {PlaneWall{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}},
                   PlaneWall{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}};
  Coordination z = coordination_of_all(set, options);
  EXPECT_EQ(z.pairs, 7u);
  EXPECT_EQ(z.wall_contacts, 5u); // two at the wall, three on the floor
  EXPECT_EQ(z.rattlers, 1u);
  EXPECT_DOUBLE_EQ(z.zpp, 14.0 / 7.0);
  EXPECT_DOUBLE_EQ(z.zpp_without_rattlers, 14.0 / 6.0);
  options.count_walls = true;
  z = coordination_of_all(set, options);
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
  const Coordination z = coordination_of_all(set, {});
  EXPECT_GT(expected, 1u);
  EXPECT_EQ(z.contacts, expected);
  EXPECT_EQ(z.pairs, 1u);
  EXPECT_DOUBLE_EQ(z.zss, static_cast<double>(expected));
  EXPECT_DOUBLE_EQ(z.zpp, 1.0);
}

/// Balls in a box, and some so far away that the cells cannot be numbered one by one.
TEST(CellGrid, finds_the_pairs_of_brute_force) {
  for (const double far_away : {1.0, 1.0e5, 1.0e12, 0.0}) { // the last one: in one layer
    std::mt19937 random(7);
    std::uniform_real_distribution<double> in_box(-1.0, 1.0), size(0.02, 0.15);
    std::vector<Vector3> centres;
    std::vector<double> radii;
    for (int k = 0; k < 300; ++k) {
      const double factor = k % 50 == 0 ? far_away : 1.0;
      centres.push_back({factor * in_box(random), in_box(random),
                         far_away > 0.0 ? factor * in_box(random) : 0.05 + 0.04 * in_box(random)});
      radii.push_back(size(random));
    }
    std::set<std::pair<std::size_t, std::size_t>> expected, found;
    for (std::size_t i = 0; i < centres.size(); ++i)
      for (std::size_t j = i + 1; j < centres.size(); ++j)
        if (norm(centres[j] - centres[i]) <= radii[i] + radii[j])
          expected.insert({i, j});
    CellGrid grid(centres, radii);
    grid.for_pairs([&](std::size_t i, std::size_t j) {
      EXPECT_TRUE(found.insert({i, j}).second) << i << " " << j;
    });
    EXPECT_GT(expected.size(), 100u);
    EXPECT_EQ(found, expected) << far_away;
  }
}

/// Ellipsoids with three different axes, of different sizes and turned at random, in a box of
/// `width`; every fourth one is a chain of three balls.
ParticleSet random_bodies(std::size_t count, double width, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> in_box(0.0, width), axis(0.02, 0.2);
  std::normal_distribution<double> gauss;
  ParticleSet set;
  for (std::size_t k = 0; k < count; ++k) {
    Particle p;
    p.semiaxes = {axis(random), axis(random), axis(random)};
    p.centre = {in_box(random), in_box(random), in_box(random)};
    p.orientation =
        normalized(Quaternion{gauss(random), gauss(random), gauss(random), gauss(random)});
    if (k % 4 == 0) {
      p.first_sphere = set.spheres.size();
      p.sphere_count = 3;
      for (const double along : {-1.0, 0.0, 1.0})
        set.spheres.push_back({p.centre + along * Vector3{0.05, 0.03, 0.0}, 0.06});
    }
    set.particles.push_back(p);
  }
  number(set);
  return set;
}

/// Every pair, body by body, searched from scratch.
TEST(Contacts, are_those_of_single_searches) {
  constexpr double gap = 0.01;
  const ParticleSet set = random_bodies(150, 1.0, 11);
  const ContactNetwork network = find_contacts(set, gap);
  const auto bodies = [&](const Particle& p) {
    std::vector<std::pair<EllipsoidShape, Vector3>> shapes;
    const auto enlarged = [&](const Vector3& s) {
      return s + Vector3{0.5 * gap, 0.5 * gap, 0.5 * gap};
    };
    if (p.is_smooth())
      shapes.push_back({make_shape(enlarged(p.semiaxes), p.orientation), p.centre});
    for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k) {
      const double r = set.spheres[k].radius;
      shapes.push_back({make_shape(enlarged({r, r, r}), {}), set.spheres[k].centre});
    }
    return shapes;
  };
  std::size_t contact = 0;
  for (std::size_t i = 0; i < set.particles.size(); ++i)
    for (std::size_t j = i + 1; j < set.particles.size(); ++j)
      for (const auto& [shape_i, centre_i] : bodies(set.particles[i]))
        for (const auto& [shape_j, centre_j] : bodies(set.particles[j])) {
          const ContactGeometry alone = find_contact(shape_i, shape_j, centre_j - centre_i);
          if (alone.overlap < 0.0)
            continue;
          ASSERT_LT(contact, network.contacts.size());
          // the search ends at an error of 1e-12 rad in the normal, and of its square in the
          // overlap
          EXPECT_NEAR(network.contacts[contact++].overlap, alone.overlap - gap, 1e-14);
        }
  EXPECT_EQ(contact, network.contacts.size());
  EXPECT_GT(contact, 200u);
}

TEST(Contacts, clusters_are_those_of_the_contacts) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const double gap = 0.002 * (seed % 3);
    const ParticleSet set = random_bodies(120, 1.9, seed);
    DisjointSets expected(set.particles.size());
    for (const PairContact& pair : find_contacts(set, gap).pairs)
      expected.join(pair.i, pair.j);
    const std::vector<std::size_t> clusters = touching_clusters(set, NearPairs(set, gap));
    std::set<std::size_t> different;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      EXPECT_EQ(clusters[i], expected.root(i)) << "seed " << seed;
      different.insert(clusters[i]);
    }
    EXPECT_GT(different.size(), 10u) << "seed " << seed;
    EXPECT_LT(different.size(), 110u) << "seed " << seed;
  }
}

} // namespace
} // namespace ellipsoid::post
