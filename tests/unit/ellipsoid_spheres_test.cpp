// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Sets of spheres for ellipsoids of any axes, against points of the ellipsoid's surface and against
// columns of the volume: nothing of the medial ellipse is used.
#include "multisphere/ellipsoid_spheres.h"
#include "multisphere/union_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ellipsoid {
namespace {

constexpr double pi = 3.14159265358979323846;
const Vector3 shapes[] = {{2.0, 1.5, 1.0}, {2.35, 1.0, 1.0}, {2.0, 2.0, 1.0},
                          {1.0, 3.0, 2.0}, {0.8, 1.0, 1.3},  {2e-3, 1e-3, 2e-3}};

std::vector<Vector3> surface_points(const Vector3& s, int count) {
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z), f = 2.399963 * i;
    points.push_back({s.x * r * std::cos(f), s.y * r * std::sin(f), s.z * z});
  }
  return points;
}

bool holds(const SphereSet& set, const Vector3& centre, double radius, double tolerance) {
  for (std::size_t k = 0; k < set.radii.size(); ++k)
    if (norm(set.centres[k] - centre) < tolerance && std::fabs(set.radii[k] - radius) < tolerance)
      return true;
  return false;
}

/// Share of the ellipsoid's volume in exactly one of it and the set: columns along z on a square
/// grid, in each the parts of the union by sorting.
double share_in_one(const Vector3& s, const SphereSet& set, int columns) {
  double sum = 0.0;
  const double width = 1.1 * s.x, depth = 1.1 * s.y;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < columns; ++j) {
      const double x = width * (2.0 * (i + 0.5) / columns - 1.0),
                   y = depth * (2.0 * (j + 0.5) / columns - 1.0);
      const double inside = 1.0 - x * x / (s.x * s.x) - y * y / (s.y * s.y),
                   half = inside > 0.0 ? s.z * std::sqrt(inside) : 0.0;
      std::vector<std::pair<double, double>> parts;
      for (std::size_t k = 0; k < set.radii.size(); ++k) {
        const double u = x - set.centres[k].x, v = y - set.centres[k].y,
                     square = set.radii[k] * set.radii[k] - u * u - v * v;
        if (square > 0.0)
          parts.emplace_back(set.centres[k].z - std::sqrt(square),
                             set.centres[k].z + std::sqrt(square));
      }
      std::sort(parts.begin(), parts.end());
      double length = 0.0, common = 0.0, reached = -1e300;
      for (const auto& [from, to] : parts) {
        const double begin = std::max(from, reached);
        length += std::max(0.0, to - begin);
        common += std::max(0.0, std::min(to, half) - std::max(begin, -half));
        reached = std::max(reached, to);
      }
      sum += length + 2.0 * half - 2.0 * common;
    }
  return sum * 4.0 * width * depth / (columns * columns) / (4.0 / 3.0 * pi * s.x * s.y * s.z);
}

std::string error_of(const Vector3& semiaxes, int count, SphereSpacing spacing) {
  try {
    make_ellipsoid_spheres(semiaxes, count, spacing);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(EllipsoidSpheres, MedialSpheresTouchFromInside) {
  for (const Vector3& s : shapes) {
    const SphereSet set = make_ellipsoid_spheres(s, 41, SphereSpacing::medial);
    ASSERT_EQ(set.count(), 41);
    const double size = std::max({s.x, s.y, s.z});
    std::vector<double> nearest(set.radii.size(), 1e300);
    for (const Vector3& p : surface_points(s, 20000))
      for (std::size_t k = 0; k < nearest.size(); ++k)
        nearest[k] = std::min(nearest[k], norm(p - set.centres[k]));
    for (std::size_t k = 0; k < nearest.size(); ++k) {
      EXPECT_GE(nearest[k], set.radii[k] * (1.0 - 1e-12)) << k;
      EXPECT_LE(nearest[k], set.radii[k] + 1e-3 * size) << k; // the points' distances, squared
    }
  }
}

/// How many spheres have no mirror image at one of the three planes.
int without_image(const SphereSet& set) {
  int missing = 0;
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    const Vector3 c = set.centres[k];
    for (const Vector3& image : {Vector3{-c.x, c.y, c.z}, {c.x, -c.y, c.z}, {c.x, c.y, -c.z}})
      if (!holds(set, image, set.radii[k], 1e-15)) {
        ++missing;
        break;
      }
  }
  return missing;
}

TEST(EllipsoidSpheres, MinimaxSetsHaveTheEllipsoidsSymmetry) {
  for (const Vector3& s : shapes)
    for (const int n : {33, 34}) {
      const SphereSet set = make_ellipsoid_spheres(s, n, SphereSpacing::minimax_volume);
      EXPECT_EQ(without_image(set), 0) << n;
      const UnionMeasures m = measure_union(set);
      EXPECT_NEAR(norm(m.centre), 0.0, 1e-12 * s.x);
      EXPECT_NEAR(m.inertia.xy, 0.0, 1e-11 * m.inertia.xx);
      EXPECT_NEAR(m.inertia.xz, 0.0, 1e-11 * m.inertia.xx);
    }
}

/// All have the centre; the other two planes of symmetry are missing for one pair at most, and the
/// next set has them again.
TEST(EllipsoidSpheres, MedialSetsAreSymmetricButForHalfAFour) {
  for (const Vector3& s : {shapes[0], shapes[1], shapes[2], shapes[3]}) {
    std::vector<int> missing; // of N = 21, 22, ...
    for (int n = 21; n <= 50; ++n) {
      const SphereSet set = make_ellipsoid_spheres(s, n, SphereSpacing::medial);
      for (std::size_t k = 0; k < set.radii.size(); ++k)
        EXPECT_TRUE(holds(set, -1.0 * set.centres[k], set.radii[k], 1e-15)) << n << " " << k;
      missing.push_back(without_image(set));
      EXPECT_TRUE(missing.back() == 0 || missing.back() == 2) << n << " " << missing.back();
      if (missing.size() > 2 && missing[missing.size() - 3] > 0) {
        EXPECT_EQ(missing.back(), 0) << n;
      }
    }
    EXPECT_GE(std::count(missing.begin(), missing.end(), 0), 15);
  }
}

/// For all N, odd and even; with chains, flat bodies, and such whose spheres are not one body yet.
TEST(EllipsoidSpheres, EachSetBeginsWithTheOneBefore) {
  for (const Vector3& s :
       {shapes[1], Vector3{1.0, 0.7, 0.4}, Vector3{1.0, 1.0, 0.1}, Vector3{0.2, 1.0, 0.3}}) {
    std::vector<SphereSet> sets(2); // two that are empty, then N = 1, 2, ...
    for (int n = 1; n <= 200; ++n) {
      sets.push_back(place_ellipsoid_spheres(s, n, SphereSpacing::medial));
      const SphereSet &set = sets.back(), &last = sets[sets.size() - 3];
      ASSERT_EQ(set.count(), n);
      for (std::size_t k = 0; k < last.radii.size(); ++k) {
        EXPECT_EQ(norm(set.centres[k] - last.centres[k]), 0.0) << n << " " << k;
        EXPECT_EQ(set.radii[k], last.radii[k]) << n << " " << k;
      }
      for (std::size_t k = last.radii.size(); k < set.radii.size(); ++k)
        EXPECT_FALSE(holds(last, set.centres[k], set.radii[k], 1e-9 * s.x)) << n << " " << k;
    }
  }
}

TEST(EllipsoidSpheres, AxesInAnyOrderAndAnyUnit) {
  for (const auto spacing : {SphereSpacing::medial, SphereSpacing::minimax_volume}) {
    const SphereSet set = make_ellipsoid_spheres({3.0, 2.0, 1.0}, 55, spacing);
    const SphereSet turned = make_ellipsoid_spheres({1e-3, 3e-3, 2e-3}, 55, spacing);
    for (std::size_t k = 0; k < set.radii.size(); ++k) {
      const Vector3 c = 1e-3 * set.centres[k];
      EXPECT_NEAR(norm(turned.centres[k] - Vector3{c.z, c.x, c.y}), 0.0, 1e-9);
      EXPECT_NEAR(turned.radii[k], 1e-3 * set.radii[k], 1e-9);
    }
  }
}

TEST(EllipsoidSpheres, OnTheAxisForTwoEqualSemiaxes) {
  const double a = 2.35, b = 1.0;
  const SphereSet set = make_ellipsoid_spheres({b, a, b}, 17, SphereSpacing::medial);
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    const double y = set.centres[k].y;
    EXPECT_EQ(set.centres[k].x, 0.0);
    EXPECT_EQ(set.centres[k].z, 0.0);
    EXPECT_NEAR(set.radii[k], b * std::sqrt(1.0 - y * y / (a * a - b * b)), 1e-14); // eq. (4)
  }
  EXPECT_TRUE(holds(set, {0.0, (a * a - b * b) / a, 0.0}, b * b / a, 1e-14)); // eq. (5)
}

TEST(EllipsoidSpheres, MinimaxVolumeIsALocalMinimum) {
  for (const Vector3& s : {shapes[0], shapes[1], shapes[2], shapes[3]}) {
    const SphereSet set = make_ellipsoid_spheres(s, 33, SphereSpacing::minimax_volume);
    const double reached = share_in_one(s, set, 300);
    const SphereSet medial = make_ellipsoid_spheres(s, 33, SphereSpacing::medial);
    EXPECT_LT(reached, 0.8 * share_in_one(s, medial, 300));
    for (const double change : {-0.01, 0.01}) {
      SphereSet thicker = set, wider = set;
      for (double& radius : thicker.radii)
        radius *= 1.0 + change;
      for (Vector3& centre : wider.centres)
        centre *= 1.0 + change;
      EXPECT_GT(share_in_one(s, thicker, 300), reached) << change;
      EXPECT_GT(share_in_one(s, wider, 300), reached) << change;
    }
  }
}

/// Of an inscribed set the two volumes differ by just this share.
TEST(EllipsoidSpheres, MedialSetsConverge) {
  for (const Vector3& s : shapes) {
    double last = 1.0;
    for (const int n : {33, 129, 513}) {
      const double missing =
          1.0 - measure_union(make_ellipsoid_spheres(s, n, SphereSpacing::medial)).volume /
                    (4.0 / 3.0 * pi * s.x * s.y * s.z);
      EXPECT_GT(missing, 0.0);
      EXPECT_LT(missing, 0.4 * last) << n; // as 1/N in the plane, 1/N^2 on the axis
      last = missing;
    }
  }
}

/// Without a sphere in the centre, and as near as the odd numbers around them.
TEST(EllipsoidSpheres, EvenNumbers) {
  for (const Vector3& s : shapes)
    for (const auto spacing : {SphereSpacing::medial, SphereSpacing::minimax_volume})
      for (const int n : {24, 34, 66}) {
        const SphereSet set = make_ellipsoid_spheres(s, n, spacing);
        ASSERT_EQ(set.count(), n);
        for (const Vector3& c : set.centres)
          EXPECT_GT(norm(c), 0.2 * std::max({s.x, s.y, s.z}) / n); // not one sphere twice
        const double share = share_in_one(s, set, 200);
        EXPECT_LT(share, 1.1 * share_in_one(s, make_ellipsoid_spheres(s, n - 3, spacing), 200))
            << word_of(spacing) << " " << n;
      }
}

TEST(EllipsoidSpheres, NoSphereOfAnEvenSetStandsTwice) {
  for (const Vector3& s : {Vector3{3.0, 2.0, 1.0},
                           {2.0, 1.5, 1.0},
                           {2.0, 2.0, 1.0},
                           {1.0, 1.0, 0.5},
                           {2.7, 1.5, 1.0},
                           {3.0, 1.0, 1.0},
                           {1.0, 3.0, 2.0}})
    for (int n = 28; n <= 120; n += 2) {
      const SphereSet set = make_ellipsoid_spheres(s, n, SphereSpacing::medial);
      ASSERT_EQ(set.count(), n);
      for (std::size_t k = 0; k < set.radii.size(); ++k)
        for (std::size_t l = 0; l < k; ++l)
          EXPECT_GT(norm(set.centres[k] - set.centres[l]), 1e-6 * s.x)
              << n << ": " << k << " " << l;
    }
}

/// Two spheres: of all pairs of inscribed ones on the axis that leave a gap within 1.25 times the
/// smallest one those farthest apart.
TEST(EllipsoidSpheres, ThePairOfTwo) {
  const double a = 1.4, b = 1.0;
  const SphereSet set = make_ellipsoid_spheres({a, b, b}, 2, SphereSpacing::medial);
  const auto gap_of = [&](double x) {
    const double r = b * std::sqrt(1.0 - x * x / (a * a - b * b)); // eq. (4)
    double gap = 0.0;
    for (const Vector3& p : surface_points({a, b, b}, 5000))
      gap = std::max(gap, norm(Vector3{std::fabs(p.x), p.y, p.z} - Vector3{x, 0.0, 0.0}) - r);
    return gap;
  };
  double farthest = 0.0;
  std::vector<double> gaps;
  for (int i = 1; i < 400; ++i)
    gaps.push_back(gap_of((a * a - b * b) / a * i / 400.0));
  const double best = *std::min_element(gaps.begin(), gaps.end());
  for (int i = 1; i < 400; ++i)
    if (gaps[static_cast<std::size_t>(i - 1)] <= 1.25 * best)
      farthest = (a * a - b * b) / a * i / 400.0;
  EXPECT_NEAR(std::fabs(set.centres[0].x), farthest, 0.01 * b);
}

TEST(EllipsoidSpheres, ARingWithAnOpenCentreIsRefused) {
  int refused = 0;
  for (const double c : {0.2, 0.3, 0.5, 0.7})
    for (int n = 2; n < 24; n += 2) {
      const SphereSet set =
          place_ellipsoid_spheres({1.0, 1.0, c}, n, SphereSpacing::minimax_volume);
      double depth = -1e300;
      for (std::size_t k = 0; k < set.radii.size(); ++k)
        depth = std::max(depth, set.radii[k] - norm(set.centres[k]));
      const std::string error = error_of({1.0, 1.0, c}, n, SphereSpacing::minimax_volume);
      refused += depth <= 0.0;
      if (depth <= 0.0) {
        EXPECT_NE(error.find("about the centre"), std::string::npos) << n;
      }
    }
  EXPECT_GT(refused, 0);
}

TEST(EllipsoidSpheres, OtherSpacingsAreChains) {
  const SphereSet set = make_ellipsoid_spheres({2.35, 1.0, 1.0}, 13, SphereSpacing::paper);
  const MultisphereTemplate chain = make_multisphere(2.35, 1.0, 13);
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    EXPECT_EQ(set.centres[k].x, chain.centres[k]);
    EXPECT_EQ(set.radii[k], chain.radii[k]);
  }
  EXPECT_NE(error_of({2.0, 1.5, 1.0}, 13, SphereSpacing::paper).find("b = c"), std::string::npos);
  EXPECT_THROW(make_multisphere(2.35, 1.0, 13, SphereSpacing::medial), std::invalid_argument);
}

TEST(EllipsoidSpheres, Refusals) {
  const auto medial = SphereSpacing::medial;
  EXPECT_NE(error_of({1.0, 1.0, 1.0}, 5, medial).find("1.000001 to 100"), std::string::npos);
  EXPECT_NE(error_of({1.0, 0.0, 1.0}, 5, medial).find("finite values > 0"), std::string::npos);
  EXPECT_NE(error_of({2.0, 1.5, 1.0}, 0, medial).find("1 to 9999"), std::string::npos);
  EXPECT_NE(error_of({2.35, 1.0, 1.0}, 4, SphereSpacing::paper).find("odd"), std::string::npos);
  EXPECT_NE(error_of({2.0, 1.5, 1.0}, 10001, medial).find("9999"), std::string::npos);
  EXPECT_NE(error_of({2.0, 1.5, 1.0}, 1001, SphereSpacing::minimax_volume).find("999"),
            std::string::npos);
  const std::string apart = error_of({5.0, 5.0, 1.0}, 5, medial);
  const std::size_t named = apart.find("not one body about the centre; N = ");
  ASSERT_NE(named, std::string::npos) << apart;
  EXPECT_EQ(error_of({5.0, 5.0, 1.0}, std::stoi(apart.substr(named + 35)), medial), "");
}

/// The N named is the next one of its parity, found here one by one.
TEST(EllipsoidSpheres, TheNextNumberThatIsEnough) {
  for (const auto spacing : {SphereSpacing::medial, SphereSpacing::minimax_volume}) {
    int refused = 0;
    for (const Vector3& s : {Vector3{5.0, 5.0, 1.0}, {1.0, 12.0, 1.0}})
      for (const int n : {3, 4}) {
        const std::string apart = error_of(s, n, spacing);
        if (apart.empty())
          continue;
        ++refused;
        const std::size_t named = apart.find("centre; N = ");
        ASSERT_NE(named, std::string::npos) << apart;
        int next = n + 2;
        while (!is_one_body(place_ellipsoid_spheres(s, next, spacing)))
          next += 2;
        EXPECT_EQ(std::stoi(apart.substr(named + 12)), next) << word_of(spacing) << " " << s.y;
      }
    EXPECT_GE(refused, 2) << word_of(spacing);
  }
}

} // namespace
} // namespace ellipsoid
