// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Exact plane geometry of outlines against closed forms and brute force.
#include "envelope.h"
#include "lens_batch.h"
#include "multisphere/multisphere_template.h"
#include "outline_level.h"
#include "union_area.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <random>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

Particle plane_particle(double a, double b, double x, double y, double angle) {
  Particle p;
  p.semiaxes = {a, b, b};
  p.centre = {x, y, 0.0};
  p.orientation = {std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle)};
  return p;
}

PlaneEllipse plane_ellipse(double a, double b, double x, double y, double angle,
                           std::size_t owner = 0) {
  PlaneEllipse shape;
  EXPECT_TRUE(section_of_ellipsoid(plane_particle(a, b, x, y, angle), 0.0, shape));
  shape.owner = owner;
  return shape;
}

/// Random ellipses that overlap strongly in a square of side 6.
std::vector<PlaneEllipse> crowd(unsigned seed, int count) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<PlaneEllipse> shapes;
  for (int k = 0; k < count; ++k)
    shapes.push_back(plane_ellipse(0.3 + uniform(generator), 0.1 + 0.3 * uniform(generator),
                                   6.0 * uniform(generator), 6.0 * uniform(generator),
                                   2.0 * pi * uniform(generator), static_cast<std::size_t>(k)));
  return shapes;
}

bool is_inside(const std::vector<PlaneEllipse>& shapes, const Point& p) {
  for (const PlaneEllipse& shape : shapes)
    if (level(shape, p) < 0.0)
      return true;
  return false;
}

TEST(PlaneEllipse, section_of_a_turned_ellipsoid_is_the_turned_ellipse) {
  const double a = 2.7, b = 1.15, angle = 0.7;
  const PlaneEllipse shape = plane_ellipse(a, b, 3.0, -2.0, angle);
  EXPECT_NEAR(shape.area(), pi * a * b, 1e-14 * pi * a * b);
  for (double t = 0.0; t < 6.28; t += 0.1) {
    const Point p = shape.at(t) - Point(3.0, -2.0);
    const double along = p.x() * std::cos(angle) + p.y() * std::sin(angle);
    const double across = -p.x() * std::sin(angle) + p.y() * std::cos(angle);
    EXPECT_NEAR(along * along / (a * a) + across * across / (b * b), 1.0, 1e-13);
  }
  EXPECT_NEAR(shape.bounding_radius(), a, 1e-14 * a);
}

TEST(PlaneEllipse, section_beside_the_centre_is_scaled_as_the_closed_form_says) {
  Particle p = plane_particle(3.0, 2.0, 0.0, 0.0, 0.4);
  p.semiaxes.z = 1.5;
  PlaneEllipse shape;
  ASSERT_TRUE(section_of_ellipsoid(p, 0.9, shape)); // area: pi a b (1 - z^2 / c^2)
  EXPECT_NEAR(shape.area(), pi * 6.0 * (1.0 - 0.36), 1e-13 * pi * 6.0);
  EXPECT_FALSE(section_of_ellipsoid(p, 1.5001, shape));
}

TEST(PlaneEllipse, upper_arc_and_the_area_below_it) {
  const PlaneEllipse shape = plane_ellipse(2.0, 0.7, 1.0, 5.0, 0.6);
  for (double share = -0.99; share < 1.0; share += 0.11) {
    const double x = 1.0 + share * shape.ux;
    EXPECT_NEAR(level(shape, {x, shape.upper(x)}), 0.0, 1e-12);
  }
  // midpoint rule with 200000 columns of the middle part, where the integrand is smooth
  const double x0 = 1.0 - 0.5 * shape.ux, x1 = 1.0 + 0.8 * shape.ux;
  double sum = 0.0;
  constexpr int columns = 200000;
  for (int k = 0; k < columns; ++k)
    sum += shape.upper(x0 + (k + 0.5) * (x1 - x0) / columns) * (x1 - x0) / columns;
  EXPECT_NEAR(shape.area_under_upper(x0, x1), sum, 1e-9);
}

TEST(Crossings, lie_on_both_outlines_and_none_is_missed) {
  int four_crossings = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const auto shapes = crowd(seed, 12);
    for (const auto& i : shapes)
      for (const auto& j : shapes) {
        if (&i == &j)
          continue;
        const auto roots = crossings(i, j);
        four_crossings += roots.size() == 4 ? 1 : 0;
        for (const double t : roots)
          EXPECT_NEAR(level(j, i.at(t)), 0.0, 1e-9);
        int changes = 0; // sign changes on 2000 points: pairs closer than that may hide
        for (int k = 0; k < 2000; ++k)
          changes += (level(j, i.at(2.0 * pi * k / 2000)) < 0.0) !=
                     (level(j, i.at(2.0 * pi * (k + 1) / 2000)) < 0.0);
        EXPECT_GE(static_cast<int>(roots.size()), changes);
        EXPECT_EQ(roots.size() % 2, 0u);
      }
  }
  EXPECT_GT(four_crossings, 100);
}

/// Angle from one direction to another, from 0 to 2 pi.
double angle_of(const ArcInterval& arc) {
  const double angle =
      std::atan2(arc.end.sine, arc.end.cosine) - std::atan2(arc.begin.sine, arc.begin.cosine);
  return angle < 0.0 ? angle + 2.0 * pi : angle;
}

void expect_same_arc(const ArcInterval& arc, const ArcInterval& expected) {
  for (const auto& [end, wanted] :
       {std::pair{arc.begin, expected.begin}, std::pair{arc.end, expected.end}}) {
    EXPECT_NEAR(end.turn, wanted.turn, 1e-9);
    EXPECT_NEAR(end.cosine, wanted.cosine, 1e-9); // small lenses: crossings at small angles
    EXPECT_NEAR(end.sine, wanted.sine, 1e-9);
  }
  EXPECT_NEAR(angle_of(arc), angle_of(expected), 1e-9);
}

/// Pairs side by side, their gap or overlap from far to a millionth of their size; and crowds.
std::vector<std::pair<PlaneEllipse, PlaneEllipse>> pairs_of_outlines() {
  std::vector<std::pair<PlaneEllipse, PlaneEllipse>> pairs;
  std::mt19937 generator(20104);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int k = 0; k < 20000; ++k) {
    const double direction = 2.0 * pi * uniform(generator);
    PlaneEllipse i =
        plane_ellipse(1.0 + 2.0 * uniform(generator), 1.0, 0.0, 0.0, 2.0 * pi * uniform(generator));
    PlaneEllipse j = plane_ellipse(1.0 + 2.0 * uniform(generator), 1.0, std::cos(direction),
                                   std::sin(direction), 2.0 * pi * uniform(generator));
    double near = 0.0, far = 10.0; // the distance at which they touch
    for (int halving = 0; halving < 50; ++halving) {
      const double distance = 0.5 * (near + far);
      j.centre = {distance * std::cos(direction), distance * std::sin(direction)};
      std::vector<ArcInterval> of_i, of_j;
      append_covered(i, j, of_i, of_j);
      (of_i.empty() ? far : near) = distance;
    }
    const double change = (k % 2 == 0 ? -1.0 : 1.0) * std::pow(10.0, -6.0 * uniform(generator));
    j.centre *= 1.0 + change;
    pairs.emplace_back(i, j);
  }
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const auto shapes = crowd(seed, 12);
    for (const auto& i : shapes)
      for (const auto& j : shapes)
        if (&i != &j)
          pairs.emplace_back(i, j);
  }
  return pairs;
}

TEST(LensBatch, finds_what_the_search_of_single_pairs_finds) {
  LensBatch batch;
  std::size_t apart = 0, lenses = 0, begin = 0;
  const auto pairs = pairs_of_outlines();
  const auto look = [&] {
    batch.solve();
    for (int k = 0; k < batch.size(); ++k) {
      const auto& [i, j] = pairs[begin + static_cast<std::size_t>(k)];
      std::vector<ArcInterval> of_i, of_j;
      append_covered(i, j, of_i, of_j);
      const auto verdict = batch.verdict(k);
      if (verdict == LensBatch::Verdict::apart) {
        ++apart;
        EXPECT_TRUE(of_i.empty() && of_j.empty());
      }
      if (verdict != LensBatch::Verdict::lens)
        continue;
      ++lenses;
      ASSERT_EQ(of_i.size(), 1u);
      ASSERT_EQ(of_j.size(), 1u);
      expect_same_arc(batch.of_i(k), of_i.front());
      expect_same_arc(batch.of_j(k), of_j.front());
    }
    begin += static_cast<std::size_t>(batch.size());
    batch.clear();
  };
  for (const auto& [i, j] : pairs) {
    batch.add(i, j);
    if (batch.full())
      look();
  }
  look();
  EXPECT_EQ(begin, pairs.size());
  std::printf("%zu pairs: %zu apart, %zu with a lens\n", begin, apart, lenses);
  EXPECT_GT(apart, 12000u);
  EXPECT_GT(lenses, 7000u); // deep overlaps are left to the other search
}

TEST(Green, arcs_of_a_turn_add_up_to_the_area) {
  const PlaneEllipse shape = plane_ellipse(2.0, 0.7, 5.0, -3.0, 0.6);
  const auto at = [](double t) {
    return ArcEnd{turn_of(std::cos(t), std::sin(t)), std::cos(t), std::sin(t)};
  };
  EXPECT_EQ(green(shape, {turn_begin, turn_end}), shape.area());
  for (const double width : {1e-7, 1e-3, 0.05, 0.099, 0.101, 1.0, 3.0, pi, 3.3, 4.0, 6.0, 6.2831}) {
    double before = 0.0;
    for (double t = 0.01; t < 2.0 * pi; t += 0.01) {
      EXPECT_GT(at(t).turn, before);
      before = at(t).turn;
      if (t + width >= 2.0 * pi)
        continue;
      const double first = green(shape, {turn_begin, at(t)});
      const double second = green(shape, {at(t), at(t + width)});
      const double third = green(shape, {at(t + width), turn_end});
      EXPECT_NEAR(first + second + third, shape.area(), 1e-13 * shape.area()) << t << ' ' << width;
      // relative to the centre: the sector of the mapped circle
      PlaneEllipse centred = shape;
      centred.centre = {0.0, 0.0};
      EXPECT_NEAR(green(centred, {at(t), at(t + width)}), 0.5 * shape.ux * shape.vy * width, 1e-14);
    }
  }
}

TEST(UnionArea, two_discs_have_the_lens_once) {
  const double d = 1.3, lens = 2.0 * std::acos(0.5 * d) - 0.5 * d * std::sqrt(4.0 - d * d);
  const std::vector<PlaneEllipse> discs = {plane_ellipse(1, 1, 0, 0, 0, 0),
                                           plane_ellipse(1, 1, d, 0, 0, 1)};
  const UnionMeasures m = union_in_region(discs, surrounding_rectangle(discs));
  EXPECT_NEAR(m.area, 2.0 * pi - lens, 1e-13);
  EXPECT_NEAR(m.area_sum, 2.0 * pi, 1e-13);
}

TEST(UnionArea, a_multisphere_chain_has_the_kernels_section_area) {
  for (const int count : {3, 5, 13, 17, 55}) {
    const MultisphereTemplate chain = make_multisphere(2.7, 1.15, count);
    std::vector<PlaneEllipse> discs;
    for (std::size_t k = 0; k < chain.centres.size(); ++k)
      discs.push_back(plane_ellipse(chain.radii[k], chain.radii[k], 7.0 + 0.6 * chain.centres[k],
                                    3.0 + 0.8 * chain.centres[k], 0));
    const UnionMeasures m = union_in_region(discs, surrounding_rectangle(discs));
    const MultisphereMeasures exact = measure(chain);
    EXPECT_NEAR(m.area, exact.area, 1e-12 * exact.area) << count;
    EXPECT_NEAR(m.area_sum, exact.area, 1e-12 * exact.area) << count;
  }
}

TEST(UnionArea, identical_outlines_count_once) {
  std::vector<PlaneEllipse> shapes(3, plane_ellipse(2.0, 0.5, 1.0, 1.0, 0.3));
  shapes[1].owner = 1;
  shapes[2].owner = 2;
  const UnionMeasures m = union_in_region(shapes, surrounding_rectangle(shapes));
  EXPECT_NEAR(m.area, pi, 1e-13);
  EXPECT_NEAR(m.area_sum, 3.0 * pi, 1e-13);
}

TEST(UnionArea, a_disc_cut_by_the_region_has_the_segments_area) {
  const std::vector<PlaneEllipse> disc = {plane_ellipse(1, 1, 0, 0, 0)};
  const double h = 0.3; // half-plane x <= h, then the quadrant x, y <= 0
  ConvexPolygon region = clipped(surrounding_rectangle(disc), {1.0, 0.0}, h);
  EXPECT_NEAR(union_in_region(disc, region).area, pi - std::acos(h) + h * std::sqrt(1.0 - h * h),
              1e-13);
  region = clipped(clipped(surrounding_rectangle(disc), {1.0, 0.0}, 0.0), {0.0, 1.0}, 0.0);
  EXPECT_NEAR(union_in_region(disc, region).area, 0.25 * pi, 1e-13);
  const ConvexPolygon inner = {{-0.1, -0.1}, {0.2, -0.1}, {0.2, 0.3}, {-0.1, 0.3}};
  EXPECT_NEAR(union_in_region(disc, inner).area, 0.12, 1e-14);
}

TEST(UnionArea, a_crowd_in_a_triangle_against_counting_points) {
  const ConvexPolygon triangle = {{0.5, 0.4}, {5.5, 1.0}, {2.0, 5.2}};
  const auto edge_side = [&](std::size_t k, const Point& p) {
    return cross(triangle[(k + 1) % 3] - triangle[k], p - triangle[k]) > 0.0;
  };
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto shapes = crowd(seed, 40);
    constexpr int grid = 1500;
    int hits = 0;
    for (int i = 0; i < grid; ++i)
      for (int j = 0; j < grid; ++j) {
        const Point p(6.0 * (i + 0.5) / grid, 6.0 * (j + 0.5) / grid);
        hits += edge_side(0, p) && edge_side(1, p) && edge_side(2, p) && is_inside(shapes, p);
      }
    const double counted = 36.0 * hits / (static_cast<double>(grid) * grid);
    // points within a cell of the boundary (about 40 long) are uncertain: error about
    // sqrt(40 / cell) cell^2 = 1.6e-3
    EXPECT_NEAR(union_in_region(shapes, triangle).area, counted, 5e-3) << "seed " << seed;
  }
}

TEST(Envelope, of_a_row_of_touching_ellipses_is_known) {
  std::vector<PlaneEllipse> row;
  const double a = 2.0, b = 0.5, y = 3.0;
  for (int k = 0; k < 10; ++k)
    for (int layer = 0; layer < 3; ++layer) // lower layers do not count
      row.push_back(plane_ellipse(a, b, a + 2.0 * a * k, y - 1.0 * layer, 0.0));
  const UpperEnvelope surface(row, 0.25);
  EXPECT_NEAR(surface.area(0.0, 40.0), 40.0 * (y - 0.25) + 10.0 * 0.5 * pi * a * b, 1e-11);
  EXPECT_NEAR(surface.height(a), y + b, 1e-14);
  EXPECT_EQ(surface.height(-1.0), 0.25);
  EXPECT_EQ(surface.height(41.0), 0.25);
  EXPECT_NEAR(surface.summit().y(), y + b, 1e-14);
}

TEST(Envelope, of_a_crowd_is_the_largest_ordinate_of_all) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto shapes = crowd(seed, 60);
    const UpperEnvelope surface(shapes, -1.0);
    double sum = 0.0;
    constexpr int columns = 40000;
    for (int k = 0; k < columns; ++k) {
      const double x = -1.5 + 9.0 * (k + 0.5) / columns;
      double highest = -1.0;
      for (const auto& shape : shapes)
        if (std::abs(x - shape.centre.x()) < shape.ux)
          highest = std::max(highest, shape.upper(x));
      EXPECT_NEAR(surface.height(x), highest, 1e-12) << "seed " << seed << " x " << x;
      sum += (highest + 1.0) * 9.0 / columns;
    }
    // steep ends of arcs: a column's width times the height, some 40 times
    EXPECT_NEAR(surface.area(-1.5, 7.5), sum, 40 * 9.0 / columns * 0.5) << "seed " << seed;
  }
}

} // namespace
} // namespace ellipsoid::post
