// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/multisphere_template.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ellipsoid {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr SphereSpacing all_spacings[] = {SphereSpacing::paper, SphereSpacing::minimax_outline,
                                          SphereSpacing::minimax_area};

/// The twelve templates of Markauskas et al. 2010, figure 4, and N = 3 at their piling's shape.
struct Case {
  double aspect_ratio;
  int count;
};
constexpr Case figure_4[] = {{1.5, 3},  {1.5, 7},   {1.5, 13}, {2.35, 3}, {2.35, 5},
                             {2.35, 9}, {2.35, 17}, {5., 11},  {5., 17},  {5., 33},
                             {10., 23}, {10., 37},  {10., 55}};

std::string error_of(double a, double b, int count, SphereSpacing spacing = SphereSpacing::paper) {
  try {
    make_multisphere(a, b, count, spacing);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Squared height of the union of discs over x, by asking every disc.
double squared_height(const MultisphereTemplate& chain, double x) {
  double largest = 0.0;
  for (std::size_t k = 0; k < chain.centres.size(); ++k) {
    const double u = x - chain.centres[k];
    largest = std::fmax(largest, chain.radii[k] * chain.radii[k] - u * u);
  }
  return largest;
}

struct Truth {
  double area = 0.0, perimeter = 0.0;
};

/// Area and perimeter of a union of discs from pairwise circle intersections and Green's theorem:
/// for every circle the angles covered by each other disc are taken away.
Truth union_of_discs(const MultisphereTemplate& chain) {
  Truth truth;
  for (std::size_t k = 0; k < chain.centres.size(); ++k) {
    const double r = chain.radii[k];
    double from = 0.0, to = pi; // visible angles of the upper half: a symmetric chain's discs
                                // cover from either end
    for (std::size_t l = 0; l < chain.centres.size(); ++l) {
      if (l == k)
        continue;
      const double d = chain.centres[l] - chain.centres[k], s = chain.radii[l];
      if (std::fabs(d) >= r + s)
        continue;
      if (std::fabs(d) + r <= s)
        from = to;
      const double cosine = (r * r + d * d - s * s) / (2.0 * r * std::fabs(d));
      if (std::fabs(cosine) >= 1.0)
        continue;
      if (d > 0.0)
        from = std::fmax(from, std::acos(cosine));
      else
        to = std::fmin(to, pi - std::acos(cosine));
    }
    if (from >= to)
      continue;
    truth.perimeter += 2.0 * r * (to - from);
    truth.area += r * (r * (to - from) + chain.centres[k] * (std::sin(to) - std::sin(from)));
  }
  return truth;
}

/// Midpoint rule for the integral of f over [-length, length].
template <class Function> double integral(double length, const Function& f) {
  constexpr int steps = 2000000;
  const double h = 2.0 * length / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
    sum += f(-length + (i + 0.5) * h);
  return sum * h;
}

/// Distance of (x, y) from the ellipse: dense search, then golden section.
double distance_from_ellipse(double a, double b, double x, double y) {
  const auto distance = [=](double t) {
    return std::hypot(x - a * std::cos(t), y - b * std::sin(t));
  };
  constexpr int steps = 2000;
  int best = 0;
  for (int i = 0; i <= steps; ++i)
    if (distance(pi * i / steps) < distance(pi * best / steps))
      best = i;
  double low = pi * (best - 1) / steps, high = pi * (best + 1) / steps;
  for (int i = 0; i < 60; ++i) {
    const double third = (high - low) / 3.0;
    if (distance(low + third) < distance(high - third))
      high -= third;
    else
      low += third;
  }
  return distance(0.5 * (low + high));
}

MultisphereTemplate chain_of(double a, double b, std::vector<double> centres,
                             std::vector<double> radii) {
  return {a, b, SphereSpacing::paper, std::move(centres), std::move(radii)};
}

// Reference values: independent computation quoted in the specification, a = 2.7, b = 1.15.
TEST(MultisphereTemplate, ReferenceRatios) {
  const auto expect = [](int count, double area, double volume, double perimeter) {
    const MultisphereMeasures m = measure(make_multisphere(2.7, 1.15, count));
    EXPECT_NEAR(m.area_ratio, area, 0.5e-4);
    EXPECT_NEAR(m.volume_ratio, volume, 0.5e-4);
    EXPECT_NEAR(m.perimeter_ratio, perimeter, 0.5e-4);
    EXPECT_DOUBLE_EQ(m.area_shape_factor, std::fabs(1.0 - m.area_ratio));
    EXPECT_DOUBLE_EQ(m.perimeter_shape_factor, std::fabs(1.0 - m.perimeter_ratio));
  };
  expect(13, 0.9908, 0.9837, 1.0022);
  expect(17, 0.9948, 0.9908, 1.0012);
}

TEST(MultisphereTemplate, ReferenceChainOfSeven) {
  const MultisphereTemplate chain = make_multisphere(2.7, 1.15, 7);
  const double x[] = {0.0, 0.7974, 1.5592, 2.2102}, r[] = {1.15, 1.0870, 0.8853, 0.4898};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(chain.centres[3 + k], x[k], 0.5e-4);
    EXPECT_NEAR(chain.radii[3 + k], r[k], 0.5e-4);
    EXPECT_EQ(chain.centres[3 - k], -chain.centres[3 + k]);
    EXPECT_EQ(chain.radii[3 - k], chain.radii[3 + k]);
  }
}

TEST(MultisphereTemplate, ObeysEquations3To8) {
  for (const Case& c : figure_4) {
    if (c.count == 3 && c.aspect_ratio >= 2.0) // does not overlap
      continue;
    const double s = c.aspect_ratio, b = 0.7, a = s * b;
    const MultisphereTemplate chain = make_multisphere(a, b, c.count);
    const auto n = static_cast<std::size_t>(c.count / 2);
    const auto x = [&](std::size_t k) { return chain.centres[n + k]; };
    const auto y = [&](std::size_t k) { return b * std::sqrt(1.0 - x(k) * x(k) / (a * a)); };
    EXPECT_EQ(x(0), 0.0);
    EXPECT_NEAR(x(n), a - b * b / a, 1e-14 * a);           // eq. 5
    EXPECT_NEAR(chain.radii[2 * n], b * b / a, 1e-14 * a); // eq. 5
    for (std::size_t k = 1; k <= n; ++k) {
      EXPECT_LT(x(k) - x(k - 1), chain.radii[n + k - 1] + chain.radii[n + k]); // after eq. 6
      if (k < n) {
        const double ratio = (x(k + 1) - x(k)) / (x(k) - x(k - 1)); // eq. 7
        EXPECT_NEAR(ratio, y(k) / y(k - 1), 1e-12);
      }
      const double tangent = x(k) * a * a / (a * a - b * b); // eq. 3
      const double ordinate = b * std::sqrt(std::fmax(0.0, 1.0 - tangent * tangent / (a * a)));
      EXPECT_NEAR(chain.radii[n + k], std::hypot(tangent - x(k), ordinate), 1e-8 * a); // eq. 4
    }
  }
}

TEST(MultisphereTemplate, OneAndThreeSpheres) {
  for (const SphereSpacing spacing : all_spacings) {
    const MultisphereTemplate one = make_multisphere(2.7, 1.15, 1, spacing);
    EXPECT_EQ(one.centres, std::vector<double>{0.0});
    EXPECT_EQ(one.radii, std::vector<double>{1.15});
  }
  const MultisphereTemplate three = make_multisphere(2.7, 1.15, 3);
  EXPECT_DOUBLE_EQ(three.radii[2], 0.5 * (2.7 - 1.15));
  EXPECT_DOUBLE_EQ(three.centres[2], three.radii[1] + three.radii[2]);
  EXPECT_DOUBLE_EQ(three.centres[2] + three.radii[2], 2.7);
  const MultisphereMeasures m = measure(three); // touching spheres: sums of whole ones
  const double r = 0.5 * (2.7 - 1.15);
  EXPECT_NEAR(m.area, pi * (1.15 * 1.15 + 2.0 * r * r), 1e-13);
  EXPECT_NEAR(m.volume, 4.0 / 3.0 * pi * (std::pow(1.15, 3) + 2.0 * r * r * r), 1e-13);
  EXPECT_NEAR(m.perimeter, 2.0 * pi * (1.15 + 2.0 * r), 1e-13);
}

/// Below s = 2 by eqs. (3) to (5) with n = 1, written out: x_1 = a - b^2/a, R_1 = b^2/a; two lenses
/// of discs are taken away. Beyond, and by name, the rule of section 4.2.1.
TEST(MultisphereTemplate, ThreeSpheresOfThePaper) {
  for (const double s : {1.1, 1.5, 1.9, 1.9999}) {
    const MultisphereTemplate three = make_multisphere(s, 1.0, 3);
    EXPECT_NEAR(three.centres[2], s - 1.0 / s, 1e-14);
    EXPECT_NEAR(three.radii[2], 1.0 / s, 1e-14);
    EXPECT_LT(three.centres[2], three.radii[1] + three.radii[2]);
  }
  const MultisphereTemplate three = make_multisphere(1.5, 1.0, 3);
  const double d = 5.0 / 6.0, r = 2.0 / 3.0;
  const double from_middle = (d * d + 1.0 - r * r) / (2.0 * d), from_side = d - from_middle;
  const double middle = std::acos(from_middle), side = std::acos(from_side / r);
  const double lens =
      middle - from_middle * std::sin(middle) + r * r * (side - from_side / r * std::sin(side));
  const double area = pi + 2.0 * pi * r * r - 2.0 * lens;
  const double perimeter = 2.0 * pi - 4.0 * middle + 2.0 * r * (2.0 * pi - 2.0 * side);
  const auto cap = [](double radius, double height) {
    return pi * height * height * (radius - height / 3.0);
  };
  const double volume = 4.0 / 3.0 * pi * (1.0 + 2.0 * r * r * r) -
                        2.0 * (cap(1.0, 1.0 - from_middle) + cap(r, r - from_side));
  const MultisphereMeasures m = measure(three);
  EXPECT_NEAR(m.area, area, 1e-13);
  EXPECT_NEAR(m.perimeter, perimeter, 1e-13);
  EXPECT_NEAR(m.volume, volume, 1e-13);
  EXPECT_NEAR(m.area_ratio, 0.914, 5e-4);
  EXPECT_NEAR(m.volume_ratio, 0.844, 5e-4);
  EXPECT_NEAR(m.perimeter_ratio, 0.998, 5e-4);
  for (const double s : {1.5, 2.0, 2.35, 3.0}) {
    const MultisphereTemplate rule = make_multisphere(s, 1.0, 3, SphereSpacing::paper_touching);
    EXPECT_DOUBLE_EQ(rule.radii[2], 0.5 * (s - 1.0));
    EXPECT_DOUBLE_EQ(rule.centres[2], 0.5 * (s + 1.0));
    if (s >= 2.0) {
      EXPECT_EQ(rule.radii, make_multisphere(s, 1.0, 3).radii);
      EXPECT_EQ(rule.centres, make_multisphere(s, 1.0, 3).centres);
    }
  }
  const MultisphereMeasures touching =
      measure(make_multisphere(1.5, 1.0, 3, SphereSpacing::paper_touching));
  EXPECT_NEAR(touching.area_ratio, 0.75, 1e-12);
  EXPECT_NEAR(touching.perimeter_ratio, 1.188, 5e-4);
  EXPECT_EQ(error_of(1.5, 1.0, 1, SphereSpacing::paper_touching), "");
  EXPECT_NE(error_of(1.5, 1.0, 5, SphereSpacing::paper_touching).find("N = 1 and 3 only"),
            std::string::npos);
  EXPECT_NE(error_of(3.1, 1.0, 3, SphereSpacing::paper_touching).find("larger than the centre"),
            std::string::npos);
  EXPECT_EQ(sphere_spacing_from_word(word_of(SphereSpacing::paper_touching)),
            SphereSpacing::paper_touching);
}

TEST(MultisphereTemplate, MeasuresAgainstIntersectionsAndQuadrature) {
  for (const SphereSpacing spacing : all_spacings)
    for (const Case& c : figure_4) {
      const MultisphereTemplate chain =
          make_multisphere(1.15 * c.aspect_ratio, 1.15, c.count, spacing);
      const double a = chain.a, b = chain.b, reach = 2.0 * a;
      const MultisphereMeasures m = measure(chain);
      const Truth truth = union_of_discs(chain);
      // The oracle finds angles by acos: only to 1e-8 where spheres just touch (N = 3).
      const double tolerance = c.count > 3 ? 1e-12 : 1e-7;
      EXPECT_NEAR(m.area, truth.area, tolerance * a * a);
      EXPECT_NEAR(m.perimeter, truth.perimeter, tolerance * a);
      const auto ellipse = [&](double x) {
        return std::fmax(0.0, b * b * (1.0 - x * x / (a * a)));
      };
      const auto sphere = [&](double x) { return squared_height(chain, x); };
      EXPECT_NEAR(m.volume, pi * integral(reach, sphere), 1e-8 * a * b * b);
      EXPECT_NEAR(m.volume_between,
                  pi * integral(reach, [&](double x) { return std::fabs(sphere(x) - ellipse(x)); }),
                  1e-8 * a * b * b);
      EXPECT_NEAR(m.area_between,
                  2.0 * integral(reach,
                                 [&](double x) {
                                   return std::fabs(std::sqrt(sphere(x)) - std::sqrt(ellipse(x)));
                                 }),
                  1e-7 * a * b);
    }
}

TEST(MultisphereTemplate, CoveredAndSeparateSpheres) {
  // A sphere wholly inside another one, and one inside the union of two others only.
  MultisphereMeasures m = measure(chain_of(3., 1., {-0.1, 0.0, 0.1}, {0.2, 1.0, 0.2}));
  EXPECT_NEAR(m.area, pi, 1e-14);
  EXPECT_NEAR(m.perimeter, 2.0 * pi, 1e-14);
  EXPECT_NEAR(m.volume, 4.0 / 3.0 * pi, 1e-14);
  const MultisphereTemplate pair = chain_of(3., 1., {-0.5, 0.5}, {1.0, 1.0});
  const MultisphereTemplate hidden = chain_of(3., 1., {-0.5, 0.0, 0.5}, {1.0, 0.8, 1.0});
  EXPECT_EQ(cut_off_spheres(hidden).size(), 2u);
  EXPECT_EQ(measure(hidden).area, measure(pair).area);
  EXPECT_EQ(measure(hidden).perimeter, measure(pair).perimeter);
  // Lens of two unit discs at distance 1: 2 pi/3 - sqrt(3)/2.
  EXPECT_NEAR(measure(pair).area, 2.0 * pi - (2.0 * pi / 3.0 - std::sqrt(0.75)), 1e-14);
  EXPECT_NEAR(measure(pair).perimeter, 8.0 / 3.0 * pi, 1e-14);
  m = measure(chain_of(3., 1., {-2.0, 0.0, 2.0}, {0.5, 1.0, 0.5}));
  EXPECT_NEAR(m.area, 1.5 * pi, 1e-14);
  EXPECT_NEAR(m.perimeter, 4.0 * pi, 1e-14);
}

TEST(MultisphereTemplate, EllipsePerimeter) {
  // The trapezoidal rule converges exponentially for periodic integrands.
  for (const double s : {1.0000001, 1.5, 2.35, 5.0, 10.0, 1000.0}) {
    constexpr int steps = 100000;
    long double expected = 0.0L;
    for (int i = 0; i < steps; ++i) {
      const long double t = 2.0L * 3.14159265358979323846L * i / steps;
      expected += std::sqrt(s * s * std::sin(t) * std::sin(t) + std::cos(t) * std::cos(t));
    }
    expected *= 2.0L * 3.14159265358979323846L / steps;
    EXPECT_NEAR(ellipse_perimeter(s, 1.0), static_cast<double>(expected), 1e-13 * s);
  }
}

TEST(MultisphereTemplate, OutlineDeviationAgainstSampling) {
  for (const SphereSpacing spacing : all_spacings)
    for (const Case& c :
         {Case{1.5, 1}, {2.35, 1}, {1.5, 3}, {2.35, 3}, {2.35, 7}, {5., 11}, {10., 23}}) {
      const MultisphereTemplate chain = make_multisphere(c.aspect_ratio, 1.0, c.count, spacing);
      const double a = chain.a;
      double largest = 0.0;
      for (const CutOffSphere& part : cut_off_spheres(chain)) {
        const auto k = static_cast<std::size_t>(part.sphere);
        const double r = chain.radii[k];
        const double from = std::asin(std::clamp((part.begin - chain.centres[k]) / r, -1.0, 1.0));
        const double to = std::asin(std::clamp((part.end - chain.centres[k]) / r, -1.0, 1.0));
        for (int i = 0; i <= 100; ++i) {
          const double t = from + (to - from) * i / 100.0;
          largest =
              std::fmax(largest, distance_from_ellipse(a, 1.0, chain.centres[k] + r * std::sin(t),
                                                       r * std::cos(t)));
        }
      }
      for (int i = 0; i <= 1000; ++i) { // from points of the ellipse to the union
        const double x = a * std::cos(pi * i / 1000.0), y = std::sin(pi * i / 1000.0);
        double nearest = 1e300;
        for (std::size_t k = 0; k < chain.centres.size(); ++k)
          nearest = std::fmin(nearest, std::hypot(x - chain.centres[k], y) - chain.radii[k]);
        largest = std::fmax(largest, nearest);
      }
      // Crests fall between samples: error up to (step)^2 times a curvature radius.
      const double deviation = measure(chain).outline_deviation;
      EXPECT_GE(deviation, largest - 1e-9 * a);
      EXPECT_LE(deviation, largest + 1e-3 * deviation);
    }
}

TEST(MultisphereTemplate, SmallestCountsOfFigure4) {
  EXPECT_EQ(smallest_overlapping_count(1.5), 3); // figure 4a
  EXPECT_EQ(smallest_overlapping_count(1.999), 3);
  EXPECT_EQ(smallest_overlapping_count(2.0), 5);
  EXPECT_EQ(smallest_overlapping_count(2.35), 5);
  EXPECT_EQ(smallest_overlapping_count(5.0), 11); // the smallest N shown in figure 4
  EXPECT_EQ(smallest_overlapping_count(10.0), 23);
  EXPECT_NE(error_of(5.0, 1.0, 9).find("is 11"), std::string::npos);
  EXPECT_NE(error_of(10.0, 1.0, 21).find("is 23"), std::string::npos);
  EXPECT_NE(error_of(10.0, 1.0, 3, SphereSpacing::minimax_outline).find("is 7"), std::string::npos);
  EXPECT_NE(error_of(20.0, 1.0, 3, SphereSpacing::minimax_area).find("is 19"), std::string::npos);
  EXPECT_NE(error_of(20.0, 1.0, 3, SphereSpacing::minimax_area).find("is 19"), std::string::npos);
  EXPECT_EQ(error_of(5.0, 1.0, 11), "");
  EXPECT_EQ(error_of(3.0, 1.0, 3), "");
  EXPECT_NE(error_of(3.01, 1.0, 3).find("larger than the centre sphere"), std::string::npos);
  for (int count = 5; count < 243; count += 2) // the bisection misses no smaller one
    EXPECT_NE(error_of(100.0, 1.0, count).find("is 243"), std::string::npos);
  EXPECT_EQ(error_of(100.0, 1.0, 243), "");
}

TEST(MultisphereTemplate, CountFromTolerance) {
  EXPECT_EQ(sphere_count_for(2.35, ShapeMeasure::area, 0.01), 13);   // paper, section 2
  EXPECT_EQ(sphere_count_for(2.35, ShapeMeasure::volume, 0.01), 17); // exact; the paper says 15
  EXPECT_THROW(sphere_count_for(2.35, ShapeMeasure::area, 0.0), std::invalid_argument);
  EXPECT_THROW(sphere_count_for(2.35, ShapeMeasure::area, std::nan("")), std::invalid_argument);
  EXPECT_THROW(sphere_count_for(1.0, ShapeMeasure::area, 0.01), std::invalid_argument);
  EXPECT_THROW(sphere_count_for(10.0, ShapeMeasure::area, 1e-12), std::invalid_argument);
  // While no sphere sticks out the area between the outlines is that of eq. (26).
  const MultisphereTemplate chain = make_multisphere(2.35, 1.0, 9);
  const MultisphereMeasures m = measure(chain);
  EXPECT_NEAR(relative_error(m, chain, ShapeMeasure::area), m.area_shape_factor, 1e-13);
  EXPECT_NEAR(relative_error(m, chain, ShapeMeasure::volume), 1.0 - m.volume_ratio, 1e-13);
}

TEST(MultisphereTemplate, MinimaxOutlineIsEqualRipple) {
  // Crests +e, notches -e, tip -e: the same ripple everywhere is the proof of optimality.
  for (const Case& c : figure_4) {
    const double a = c.aspect_ratio;
    const MultisphereTemplate chain =
        make_multisphere(a, 1.0, c.count, SphereSpacing::minimax_outline);
    const double e = measure(chain).outline_deviation;
    const std::vector<CutOffSphere> parts = cut_off_spheres(chain);
    ASSERT_EQ(static_cast<int>(parts.size()), c.count);
    EXPECT_NEAR(a - parts.back().end, e, 1e-12 * a);
    for (const CutOffSphere& part : parts) {
      const auto k = static_cast<std::size_t>(part.sphere);
      const double x = chain.centres[k], r = chain.radii[k];
      const double inscribed = std::sqrt(1.0 - x * x / (a * a - 1.0)); // eq. 4
      EXPECT_NEAR(r - inscribed, e, 1e-12 * a);
      if (part.sphere + 1 == c.count)
        continue;
      const double height = std::sqrt(r * r - (part.end - x) * (part.end - x));
      EXPECT_NEAR(distance_from_ellipse(a, 1.0, part.end, height), e, 1e-8 * a);
    }
  }
}

TEST(MultisphereTemplate, MinimaxBeatsPerturbedChainsAndPaper) {
  std::mt19937_64 random(20100603);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const Case& c : figure_4) {
    const MultisphereMeasures paper = measure(make_multisphere(c.aspect_ratio, 1.0, c.count));
    const MultisphereTemplate outline =
        make_multisphere(c.aspect_ratio, 1.0, c.count, SphereSpacing::minimax_outline);
    const MultisphereTemplate area =
        make_multisphere(c.aspect_ratio, 1.0, c.count, SphereSpacing::minimax_area);
    const double best_outline = measure(outline).outline_deviation;
    const double best_area = measure(area).area_between;
    EXPECT_LT(best_outline, paper.outline_deviation);
    EXPECT_LT(best_outline, measure(area).outline_deviation);
    EXPECT_LT(best_area, paper.area_between);
    EXPECT_LT(best_area, measure(outline).area_between);
    for (int trial = 0; trial < 300; ++trial) {
      const double size = std::pow(10.0, -2.0 + 2.0 * uniform(random)); // 1e-4 to 1
      const auto perturbed = [&](MultisphereTemplate chain, double scale) {
        const std::size_t n = chain.centres.size() / 2;
        for (std::size_t k = 0; k <= n; ++k) {
          const double radius = chain.radii[n + k] + scale * uniform(random);
          const double centre = chain.centres[n + k] + (k == 0 ? 0.0 : scale * uniform(random));
          chain.radii[n + k] = chain.radii[n - k] = radius;
          chain.centres[n + k] = centre;
          chain.centres[n - k] = -centre;
        }
        return chain;
      };
      const double scale = size * best_outline;
      EXPECT_GE(measure(perturbed(outline, scale)).outline_deviation, best_outline * (1.0 - 1e-10));
      EXPECT_GE(measure(perturbed(area, scale)).area_between, best_area * (1.0 - 1e-10));
    }
  }
}

TEST(MultisphereTemplate, ScaleInvarianceAndReproducibility) {
  for (const SphereSpacing spacing : all_spacings) {
    const MultisphereTemplate one = make_multisphere(2.5, 1.0, 9, spacing);
    const MultisphereTemplate again = make_multisphere(2.5, 1.0, 9, spacing);
    const MultisphereTemplate small = make_multisphere(2.5 / 1024, 1.0 / 1024, 9, spacing);
    EXPECT_EQ(one.centres, again.centres);
    EXPECT_EQ(one.radii, again.radii);
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_EQ(small.centres[k] * 1024, one.centres[k]); // a power of two: to the last bit
      EXPECT_EQ(small.radii[k] * 1024, one.radii[k]);
    }
  }
}

TEST(MultisphereTemplate, ExtremeShapesConverge) {
  for (const double s : {1.0001, 1.01, 1.2, 3.0, 20.0})
    for (const int count : {47, 101, 255})
      for (const SphereSpacing spacing : all_spacings) {
        const MultisphereTemplate chain = make_multisphere(s, 1.0, count, spacing);
        ASSERT_EQ(chain.count(), count);
        EXPECT_TRUE(std::is_sorted(chain.centres.begin(), chain.centres.end()));
        EXPECT_LT(measure(chain).area_shape_factor, 0.1);
        if (spacing != SphereSpacing::minimax_area)
          continue;
        const MultisphereTemplate outline =
            make_multisphere(s, 1.0, count, SphereSpacing::minimax_outline);
        EXPECT_LT(measure(chain).area_between, measure(outline).area_between);
      }
}

TEST(MultisphereTemplate, MinimaxNeedsFewerSpheres) {
  const std::vector<SpacingComparison> rows = compare_spacings({1.5, 2.35, 5.0, 10.0}, 0.01);
  ASSERT_EQ(rows.size(), 12u);
  for (const SpacingComparison& row : rows) {
    if (row.what == ShapeMeasure::volume)
      continue;
    const bool outline = row.what == ShapeMeasure::outline;
    EXPECT_LE(outline ? row.minimax_outline : row.minimax_area, row.paper);
    EXPECT_LE(outline ? row.minimax_outline : row.minimax_area,
              outline ? row.minimax_area : row.minimax_outline);
  }
}

TEST(MultisphereTemplate, RefusesBadInput) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_NE(error_of(2.7, 1.15, 4).find("N = 4"), std::string::npos);
  EXPECT_NE(error_of(2.7, 1.15, 4).find("use 3 or 5"), std::string::npos);
  for (const int count : {0, -1, -3, 1000, 1001, 1001001})
    EXPECT_NE(error_of(2.7, 1.15, count).find("from 1 to 999"), std::string::npos);
  const double bad[][2] = {{1., 1.},           {1., 2.}, {infinity, 1.}, {2., std::nan("")},
                           {std::nan(""), 1.}, {2., 0.}, {2., -1.},      {-1., -2.}};
  for (const auto& shape : bad)
    for (const int count : {1, 3, 5})
      EXPECT_NE(error_of(shape[0], shape[1], count).find("a > b > 0"), std::string::npos);
  for (const double a : {1.0 + 1e-12, 1.0000009, 100.1, 1e160, 1e300})
    EXPECT_NE(error_of(a, 1.0, 5).find("to 100:"), std::string::npos);
  EXPECT_NE(error_of(1e300, 1e-300, 5).find("to 100:"), std::string::npos);
  EXPECT_EQ(error_of(2.7, 1.15, 4).find('\n'), std::string::npos);
}

TEST(MultisphereTemplate, SpacingWords) {
  for (const SphereSpacing spacing : all_spacings)
    EXPECT_EQ(sphere_spacing_from_word(word_of(spacing)), spacing);
  EXPECT_EQ(sphere_spacing_from_word("minimax"), SphereSpacing::minimax_outline);
  for (const char* word : {"", "Paper", "minimax ", "2"})
    EXPECT_THROW(sphere_spacing_from_word(word), std::invalid_argument);
}

} // namespace
} // namespace ellipsoid
