// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Oracles that share nothing with the arcs on spheres: closed forms, sections (areas of unions of
// discs, integrated over their height), random points.
#include "multisphere/multisphere_template.h"
#include "multisphere/union_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ellipsoid {
namespace {

constexpr double pi = 3.14159265358979323846;

double cap_volume(double r, double height) { return pi * height * height * (r - height / 3.0); }

/// Relative to `size`, each entry.
void expect_near(const SymmetricMatrix3& found, const SymmetricMatrix3& wanted, double tolerance) {
  EXPECT_NEAR(found.xx, wanted.xx, tolerance);
  EXPECT_NEAR(found.yy, wanted.yy, tolerance);
  EXPECT_NEAR(found.zz, wanted.zz, tolerance);
  EXPECT_NEAR(found.xy, wanted.xy, tolerance);
  EXPECT_NEAR(found.xz, wanted.xz, tolerance);
  EXPECT_NEAR(found.yz, wanted.yz, tolerance);
}

/// Area of a union of discs by Green's theorem over the uncovered angles of each circle.
double area_of_discs(const std::vector<std::array<double, 3>>& discs) {
  double area = 0.0;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const auto [x, y, r] = discs[k];
    std::vector<std::pair<double, double>> covered;
    for (std::size_t l = 0; l < discs.size(); ++l) {
      const double dx = discs[l][0] - x, dy = discs[l][1] - y, s = discs[l][2],
                   d = std::hypot(dx, dy);
      if (l == k || d >= r + s || d + s <= r)
        continue;
      if (d + r <= s) {
        covered.assign(1, {-pi, pi});
        break;
      }
      const double half = std::acos((r * r + d * d - s * s) / (2.0 * r * d)),
                   middle = std::atan2(dy, dx), from = middle - half, to = middle + half;
      covered.emplace_back(std::max(from, -pi), std::min(to, pi));
      if (from < -pi)
        covered.emplace_back(from + 2.0 * pi, pi);
      if (to > pi)
        covered.emplace_back(-pi, to - 2.0 * pi);
    }
    std::sort(covered.begin(), covered.end());
    covered.emplace_back(pi, pi);
    double reached = -pi;
    for (const auto& [from, to] : covered) {
      if (from > reached)
        area += 0.5 * (r * r * (from - reached) + r * x * (std::sin(from) - std::sin(reached)) -
                       r * y * (std::cos(from) - std::cos(reached)));
      reached = std::max(reached, to);
    }
  }
  return area;
}

/// Volume from sections z = const, midpoints in the angle t of z = -cos t: ends are smooth then.
double volume_by_sections(const SphereSet& set, int sections) {
  double low = 1e300, high = -1e300, volume = 0.0;
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    low = std::min(low, set.centres[k].z - set.radii[k]);
    high = std::max(high, set.centres[k].z + set.radii[k]);
  }
  for (int i = 0; i < sections; ++i) {
    const double t = pi * (i + 0.5) / sections,
                 z = 0.5 * (low + high) - 0.5 * (high - low) * std::cos(t);
    std::vector<std::array<double, 3>> discs;
    for (std::size_t k = 0; k < set.radii.size(); ++k) {
      const double u = z - set.centres[k].z, square = set.radii[k] * set.radii[k] - u * u;
      if (square > 0.0)
        discs.push_back({set.centres[k].x, set.centres[k].y, std::sqrt(square)});
    }
    volume += area_of_discs(discs) * std::sin(t);
  }
  return volume * 0.5 * (high - low) * pi / sections;
}

/// Every measure against random points, each mean within 5 of its standard deviations.
void expect_random_points_agree(const SphereSet& set, int points) {
  const UnionMeasures found = measure_union(set);
  const auto is_inside = [&](const Vector3& p, std::size_t but) {
    for (std::size_t k = 0; k < set.radii.size(); ++k) {
      const Vector3 u = p - set.centres[k];
      if (k != but && dot(u, u) < set.radii[k] * set.radii[k])
        return true;
    }
    return false;
  };
  double reach = 0.0, sphere_area = 0.0;
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    reach = std::max(reach, norm(set.centres[k]) + set.radii[k]);
    sphere_area += 4.0 * pi * set.radii[k] * set.radii[k];
  }
  std::mt19937_64 random(20100117);
  std::uniform_real_distribution<double> in_box(-reach, reach);
  double sum[10] = {}, squares[10] = {};
  for (int i = 0; i < points; ++i) {
    const Vector3 p{in_box(random), in_box(random), in_box(random)};
    if (!is_inside(p, set.radii.size()))
      continue;
    const Vector3 u = p - found.centre;
    const double values[10] = {1.0,
                               u.x,
                               u.y,
                               u.z,
                               u.y * u.y + u.z * u.z,
                               u.x * u.x + u.z * u.z,
                               u.x * u.x + u.y * u.y,
                               -u.x * u.y,
                               -u.x * u.z,
                               -u.y * u.z};
    for (int m = 0; m < 10; ++m) {
      sum[m] += values[m];
      squares[m] += values[m] * values[m];
    }
  }
  const double box = 8.0 * reach * reach * reach;
  const SymmetricMatrix3& t = found.inertia;
  const double wanted[10] = {found.volume, 0.0, 0.0, 0.0, t.xx, t.yy, t.zz, t.xy, t.xz, t.yz};
  for (int m = 0; m < 10; ++m) {
    const double mean = sum[m] / points,
                 deviation = std::sqrt((squares[m] / points - mean * mean) / points);
    EXPECT_NEAR(box * mean, wanted[m], 5.0 * box * deviation) << "moment " << m;
  }
  // the surface from points on the spheres, by their areas
  std::vector<double> areas;
  for (const double r : set.radii)
    areas.push_back(r * r);
  std::discrete_distribution<std::size_t> which(areas.begin(), areas.end());
  std::normal_distribution<double> gauss;
  const int on_surface = points / 10;
  int uncovered = 0;
  for (int i = 0; i < on_surface; ++i) {
    const std::size_t k = which(random);
    const Vector3 n = normalized(Vector3{gauss(random), gauss(random), gauss(random)});
    uncovered += !is_inside(set.centres[k] + set.radii[k] * n, k);
  }
  const double share = static_cast<double>(uncovered) / on_surface;
  EXPECT_NEAR(share * sphere_area, found.surface,
              5.0 * sphere_area * std::sqrt(share * (1.0 - share) / on_surface));
}

SphereSet random_set(int count, unsigned seed, double spread) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-spread, spread), radius(0.3, 1.0);
  SphereSet set;
  for (int k = 0; k < count; ++k) {
    set.centres.push_back({place(random), 0.6 * place(random), 0.4 * place(random)});
    set.radii.push_back(radius(random));
  }
  return set;
}

TEST(UnionMeasures, OneSphereAnywhere) {
  const double r = 1.7;
  const UnionMeasures m = measure_union({{{11.0, -7.0, 3.0}}, {r}});
  const double volume = 4.0 / 3.0 * pi * r * r * r;
  EXPECT_NEAR(m.volume, volume, 1e-14 * volume);
  EXPECT_NEAR(m.surface, 4.0 * pi * r * r, 1e-13);
  EXPECT_NEAR(norm(m.centre - Vector3{11.0, -7.0, 3.0}), 0.0, 1e-14);
  const double moment = 0.4 * volume * r * r;
  expect_near(m.inertia, {moment, moment, moment, 0.0, 0.0, 0.0}, 1e-12);
}

TEST(UnionMeasures, TwoSpheresOfTwoSizes) {
  const double r = 1.0, s = 0.7, d = 1.2, plane = (d * d + r * r - s * s) / (2.0 * d);
  const Vector3 axis = normalized(Vector3{1.0, -2.0, 0.5});
  const UnionMeasures m = measure_union({{{}, d * axis}, {r, s}});
  const double volume = 4.0 / 3.0 * pi * (r * r * r + s * s * s) - cap_volume(r, r - plane) -
                        cap_volume(s, s - (d - plane));
  EXPECT_NEAR(m.volume, volume, 1e-14 * volume);
  EXPECT_NEAR(m.surface, 2.0 * pi * (r * (r + plane) + s * (s + d - plane)), 1e-13);
  // cut by planes across the axis, both parts are spherical segments: integrals of u^k pi y^2
  const auto part = [](double radius, double from, double to, double shift, int power) {
    const int slices = 20000; // Simpson's rule is exact for these polynomials
    double sum = 0.0;
    for (int i = 0; i <= slices; ++i) {
      const double u = from + (to - from) * i / slices, weight = i == 0 || i == slices ? 1.0
                                                                 : i % 2               ? 4.0
                                                                                       : 2.0;
      sum += weight * std::pow(u + shift, power) * pi * (radius * radius - u * u);
    }
    return sum * (to - from) / (3.0 * slices);
  };
  const auto along = [&](int power) {
    return part(r, -r, plane, 0.0, power) + part(s, plane - d, s, d, power);
  };
  const double mean = along(1) / volume;
  EXPECT_NEAR(norm(m.centre - mean * axis), 0.0, 1e-12);
  // about the axis: half the integral of y^4 pi
  const auto fourth = [](double radius, double from, double to) {
    const auto f = [&](double u) {
      const double q = radius * radius;
      return q * q * u - 2.0 / 3.0 * q * u * u * u + 0.2 * u * u * u * u * u;
    };
    return pi * (f(to) - f(from));
  };
  const double around = 0.5 * (fourth(r, -r, plane) + fourth(s, plane - d, s));
  const double across = 0.5 * around + along(2) - volume * mean * mean;
  EXPECT_NEAR(dot(axis, m.inertia * axis), around, 1e-12);
  const Vector3 other = normalized(cross(axis, Vector3{0.0, 0.0, 1.0}));
  EXPECT_NEAR(dot(other, m.inertia * other), across, 1e-11);
  EXPECT_NEAR(dot(other, m.inertia * axis), 0.0, 1e-12);
}

TEST(UnionMeasures, ThreeSpheresBySections) {
  const SphereSet set{{{0.0, 0.0, 0.0}, {0.9, 0.1, 0.0}, {0.4, 0.8, 0.3}}, {1.0, 0.8, 0.6}};
  EXPECT_NEAR(measure_union(set).volume, volume_by_sections(set, 40000), 2e-8);
}

TEST(UnionMeasures, RandomSetsBySections) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const SphereSet set = random_set(5 + 5 * static_cast<int>(seed), seed, 1.5);
    const double wanted = volume_by_sections(set, 4000);
    EXPECT_NEAR(measure_union(set).volume, wanted, 1e-5 * wanted) << "seed " << seed;
  }
}

TEST(UnionMeasures, RandomPoints) {
  expect_random_points_agree(random_set(9, 77, 1.2), 10000000);
  expect_random_points_agree(random_set(30, 78, 2.5), 1000000);
}

TEST(UnionMeasures, ChainsAgreeWithTheirOwnMeasures) {
  for (const int count : {5, 17, 55}) {
    const MultisphereTemplate chain = make_multisphere(2.35, 1.0, count);
    SphereSet set;
    for (std::size_t k = 0; k < chain.centres.size(); ++k) {
      set.centres.push_back({0.3, chain.centres[k], -0.1});
      set.radii.push_back(chain.radii[k]);
    }
    const UnionMeasures m = measure_union(set);
    EXPECT_NEAR(m.volume, measure(chain).volume, 1e-13 * m.volume) << count;
    EXPECT_NEAR(norm(m.centre - Vector3{0.3, 0.0, -0.1}), 0.0, 1e-13);
  }
}

TEST(UnionMeasures, WhatIsHiddenChangesNothing) {
  const SphereSet set = random_set(8, 5, 1.0);
  const UnionMeasures wanted = measure_union(set);
  SphereSet more = set;
  for (std::size_t k = 0; k < set.radii.size();
       ++k) { // contained, touching inside, about one centre
    more.centres.insert(more.centres.begin(), set.centres[k] + Vector3{0.1, 0.0, 0.05});
    more.radii.insert(more.radii.begin(), set.radii[k] - 0.15);
    more.centres.push_back(set.centres[k] + Vector3{0.0, 0.5 * set.radii[k], 0.0});
    more.radii.push_back(0.5 * set.radii[k]);
    more.centres.push_back(set.centres[k]);
    more.radii.push_back(0.9 * set.radii[k]);
  }
  const UnionMeasures found = measure_union(more);
  EXPECT_NEAR(found.volume, wanted.volume, 1e-12);
  EXPECT_NEAR(found.surface, wanted.surface, 1e-6); // a point's touching: its cap's rounding
  EXPECT_NEAR(norm(found.centre - wanted.centre), 0.0, 1e-12);
  expect_near(found.inertia, wanted.inertia, 1e-12);
}

TEST(UnionMeasures, EqualSpheresAreRefused) {
  SphereSet set = random_set(8, 5, 1.0);
  set.centres.push_back(set.centres[2]);
  set.radii.push_back(set.radii[2]);
  EXPECT_ANY_THROW(measure_union(set));
}

TEST(UnionMeasures, SpheresThroughOneCircle) {
  SphereSet set; // all meet in the unit circle z = 0; the two outer ones hide the others
  for (const double z : {-1.0, -0.5, -0.25, 0.0, 0.125, 0.7, 1.2}) {
    set.centres.push_back({0.0, 0.0, z});
    set.radii.push_back(std::sqrt(1.0 + z * z));
  }
  const double r = std::sqrt(2.0), s = std::sqrt(1.0 + 1.44);
  const UnionMeasures m = measure_union(set);
  EXPECT_NEAR(m.volume, cap_volume(r, r + 1.0) + cap_volume(s, s + 1.2), 1e-11);
  EXPECT_NEAR(m.surface, 2.0 * pi * (r * (r + 1.0) + s * (s + 1.2)), 1e-10);
}

TEST(UnionMeasures, FourSpheresThroughOnePoint) {
  SphereSet set{{{1., 1., 1.}, {1., -1., -1.}, {-1., 1., -1.}, {-1., -1., 1.}}, {}};
  set.radii.assign(4, std::sqrt(3.0));
  EXPECT_NEAR(measure_union(set).volume, volume_by_sections(set, 40000), 1e-7);
  const double surface = measure_union(set).surface;
  for (double& r : set.radii) // a hollow of the size of 1e-7 opens at most
    r -= 1e-7;
  EXPECT_NEAR(measure_union(set).surface, surface, 1e-5);
}

TEST(UnionMeasures, LatticeOfSpheresThatTouchOrOverlap) {
  for (const double r : {0.5, 0.6, std::sqrt(0.5), 0.8, std::sqrt(0.75)}) { // edges, faces, corners
    SphereSet set;
    for (int k = 0; k < 27; ++k) {
      set.centres.push_back({static_cast<double>(k % 3), k / 3 % 3 * 1.0, k / 9 * 1.0});
      set.radii.push_back(r);
    }
    const double wanted = volume_by_sections(set, 20000);
    const UnionMeasures m = measure_union(set);
    EXPECT_NEAR(m.volume, wanted, 1e-6 * wanted) << r;
    EXPECT_NEAR(norm(m.centre - Vector3{1.0, 1.0, 1.0}), 0.0, 1e-13);
    EXPECT_NEAR(m.inertia.xx, m.inertia.zz, 1e-11);
    EXPECT_NEAR(m.inertia.xy, 0.0, 1e-11);
  }
}

TEST(UnionMeasures, TouchingSpheresAreJustSums) {
  const UnionMeasures m = measure_union({{{0., 0., 0.}, {3., 4., 0.}}, {2.0, 3.0}});
  EXPECT_NEAR(m.volume, 4.0 / 3.0 * pi * 35.0, 1e-11);
  EXPECT_NEAR(m.surface, 4.0 * pi * 13.0, 1e-11);
}

TEST(UnionMeasures, ThousandsOfSpheresScaleAndTurn) {
  const SphereSet set = random_set(3000, 9, 12.0);
  const UnionMeasures m = measure_union(set);
  const Rotation3 turn = rotation(normalized(Quaternion{0.3, -0.5, 0.7, 0.2}));
  SphereSet other;
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    other.centres.push_back(1e-3 * turn.to_space(set.centres[k]) + Vector3{0.01, 0.02, -0.03});
    other.radii.push_back(1e-3 * set.radii[k]);
  }
  const UnionMeasures n = measure_union(other);
  EXPECT_NEAR(n.volume * 1e9, m.volume, 1e-10 * m.volume);
  EXPECT_NEAR(n.surface * 1e6, m.surface, 1e-9 * m.surface);
  EXPECT_NEAR(norm(n.centre - Vector3{0.01, 0.02, -0.03} - 1e-3 * turn.to_space(m.centre)), 0.0,
              1e-13);
  const double trace = m.inertia.xx + m.inertia.yy + m.inertia.zz;
  EXPECT_NEAR((n.inertia.xx + n.inertia.yy + n.inertia.zz) * 1e15, trace, 1e-9 * trace);
}

TEST(UnionMeasures, RefusesWhatIsNoSetOfSpheres) {
  EXPECT_THROW(measure_union({}), std::invalid_argument);
  EXPECT_THROW(measure_union({{{}}, {0.0}}), std::invalid_argument);
}

} // namespace
} // namespace ellipsoid
