// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Elliptic Hertz contact against numerical integration, a printed table and the sphere, and the
// relative curvatures of ellipsoids against gaps measured between their surfaces.
#include "ellipsoid/elliptic_hertz.h"

#include "ellipsoid/ellipsoid_contact.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace {

using namespace ellipsoid;

/// Curvatures A = 1, B = ratio.
EllipticContact contact_of(double ratio) { return elliptic_hertz({1.0, ratio}); }

/// Integral over all x of a smooth function that falls off exponentially on both sides: the
/// trapezoidal rule converges exponentially (Trefethen and Weideman 2014, SIAM Review 56, 385).
template <typename Function> double integral(Function f, double range) {
  const int steps = 4000;
  double sum = 0.0;
  for (int k = -steps; k <= steps; ++k)
    sum += f(range * k / steps);
  return sum * range / steps;
}

TEST(EllipticIntegrals, AgreeWithNumericalIntegration) {
  for (const double k : {1.0, 0.9999999, 0.97, 0.5, 0.1, 1e-2, 1e-4}) {
    // K = int_0^inf dt / sqrt((1 + t^2)(1 + k^2 t^2)), D with t^2 / (1 + t^2) in it; t = e^x
    const auto root = [k](double t) { return std::sqrt((1.0 + t * t) * (1.0 + k * k * t * t)); };
    const double K = integral([&](double x) { return std::exp(x) / root(std::exp(x)); }, 60.0);
    const double D = integral(
        [&](double x) {
          const double t = std::exp(x);
          return t / root(t) / (1.0 + 1.0 / (t * t));
        },
        60.0);
    const EllipticIntegrals found = elliptic_integrals(k);
    EXPECT_NEAR(found.first / K, 1.0, 1e-13) << k;
    EXPECT_NEAR(found.second / D, 1.0, 1e-13) << k;
  }
}

TEST(EllipticIntegrals, MeetPrintedValues) {
  // Abramowitz and Stegun 1964, tables 17.1 and 17.2, m = 0.5: K = 1.85407 46773, E = 1.35064 38810
  const EllipticIntegrals found = elliptic_integrals(std::sqrt(0.5));
  EXPECT_NEAR(found.first, 1.8540746773, 1e-10);
  EXPECT_NEAR(found.second, (1.8540746773 - 1.3506438810) / 0.5, 1e-9);
}

TEST(EllipticHertz, EqualCurvaturesGiveTheSphere) {
  for (const double radius : {1e-3, 0.7, 40.0}) {
    const double curvature = 0.5 / radius;
    const EllipticContact c = elliptic_hertz({curvature, curvature});
    EXPECT_NEAR(c.effective_radius / radius, 1.0, 1e-14);
    EXPECT_NEAR(c.area_per_overlap / (M_PI * radius), 1.0, 1e-14);
    EXPECT_DOUBLE_EQ(c.axis_ratio, 1.0);
  }
}

TEST(EllipticHertz, PressureOnTheEllipseGivesTheCurvatures) {
  // The displacement under p0 sqrt(1 - x^2/a^2 - y^2/b^2) is (L - M x^2 - N y^2) / (pi E*) with
  // L, M, N = pi p0 a b / 2 times integrals over w (Johnson 1985, eqs. 3.68, 3.69; w = t^2).
  for (const double ratio : {1.0, 1.001, 2.0, 10.0, 300.0, 1e5}) {
    const EllipticContact c = contact_of(ratio);
    const double overlap = 1e-3;
    const double a = std::sqrt(c.area_per_overlap * overlap / (M_PI * c.axis_ratio));
    const double b = c.axis_ratio * a;
    const auto potential = [&](double power_a, double power_b) {
      return integral(
          [&](double x) {
            const double t = std::sqrt(a * b) * std::exp(x);
            return 2.0 * t * std::pow(a * a + t * t, -power_a) * std::pow(b * b + t * t, -power_b);
          },
          60.0);
    };
    const double L = potential(0.5, 0.5), M = potential(1.5, 0.5), N = potential(0.5, 1.5);
    EXPECT_NEAR(M / L * overlap, 1.0, 1e-11) << ratio;         // A
    EXPECT_NEAR(N / L * overlap / ratio, 1.0, 1e-11) << ratio; // B
    // force 2/3 pi a b p0 with overlap = a b p0 L / (2 E*)
    const double force = 2.0 / 3.0 * M_PI * 2.0 * overlap / L; // over E*
    const double expected = 4.0 / 3.0 * std::sqrt(c.effective_radius) * std::pow(overlap, 1.5);
    EXPECT_NEAR(force / expected, 1.0, 1e-12) << ratio;
  }
}

TEST(EllipticHertz, MeetsTimoshenkosTable) {
  // Timoshenko and Goodier, Theory of Elasticity, 3rd ed. 1970, section 140: semi-axes m and n of
  // the contact ellipse in units of (3 P / (4 E* (A + B)))^(1/3), cos(theta) = (B - A) / (A + B)
  // (printed to three digits and good to 2.1 in the last one, as the integrals above show: 70
  // degrees)
  const double table[][3] = {{30, 2.731, 0.493}, {35, 2.397, 0.530}, {40, 2.136, 0.567},
                             {45, 1.926, 0.604}, {50, 1.754, 0.641}, {55, 1.611, 0.678},
                             {60, 1.486, 0.717}, {65, 1.378, 0.759}, {70, 1.284, 0.802},
                             {75, 1.202, 0.846}, {80, 1.128, 0.893}, {85, 1.061, 0.944},
                             {90, 1.000, 1.000}};
  for (const auto& row : table) {
    const double cosine = std::cos(row[0] * M_PI / 180.0);
    const double ratio = (1.0 + cosine) / (1.0 - cosine);
    const EllipticContact c = contact_of(ratio);
    const double overlap = 1.0; // P / E* = 4/3 sqrt(R)
    const double unit = std::cbrt(std::sqrt(c.effective_radius) / (1.0 + ratio));
    const double a = std::sqrt(c.area_per_overlap * overlap / (M_PI * c.axis_ratio));
    EXPECT_NEAR(a / unit, row[1], 2.2e-3) << row[0];
    EXPECT_NEAR(c.axis_ratio * a / unit, row[2], 2.2e-3) << row[0];
  }
}

TEST(EllipticHertz, RisesAboveTheCircleMonotonically) {
  double last = 1.0;
  for (double ratio = 1.0; ratio < 1e8; ratio *= 1.37) {
    const double against_circle = contact_of(ratio).effective_radius * 2.0 * std::sqrt(ratio);
    EXPECT_GE(against_circle, last - 1e-14);
    last = against_circle;
  }
}

/// Distance along the normal from the tangent plane at the farthest point down to the surface.
double sag(const EllipsoidShape& shape, const Vector3& normal, const Vector3& offset) {
  // surface point p + offset - z n on x^T A^-1 x = 1, by its support function: bisection on the
  // separating plane of the point
  const Vector3 top = (1.0 / support(shape, normal)) * (shape.a_matrix * normal);
  const auto outside = [&](double z) {
    const Vector3 x = top + offset - z * normal;
    // x^T A^-1 x by Cramer's rule
    const SymmetricMatrix3& m = shape.a_matrix;
    const SymmetricMatrix3 adjugate{m.yy * m.zz - m.yz * m.yz, m.xx * m.zz - m.xz * m.xz,
                                    m.xx * m.yy - m.xy * m.xy, m.xz * m.yz - m.xy * m.zz,
                                    m.xy * m.yz - m.xz * m.yy, m.xy * m.xz - m.yz * m.xx};
    return dot(x, adjugate * x) > shape.axes_product * shape.axes_product;
  };
  double low = 0.0, high = support(shape, normal);
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (outside(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

TEST(RelativeCurvature, IsThatOfTheGapBetweenTheSurfaces) {
  std::mt19937_64 random(20240711);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0), axis(0.5, 2.0);
  const auto direction = [&] {
    for (;;) {
      const Vector3 v{uniform(random), uniform(random), uniform(random)};
      if (dot(v, v) < 1.0 && dot(v, v) > 0.01)
        return normalized(v);
    }
  };
  for (int trial = 0; trial < 200; ++trial) {
    EllipsoidShape shapes[2];
    for (EllipsoidShape& s : shapes)
      s = make_shape(
          {axis(random), axis(random), axis(random)},
          normalized(Quaternion{uniform(random), uniform(random), uniform(random), 1.2}));
    const Vector3 normal = direction();
    const RelativeCurvature found = relative_curvature(shapes[0], shapes[1], normal);
    ASSERT_LE(found.smaller, found.larger);
    // the gap's quadratic form by differences along two directions and their bisector
    const Vector3 first = normalized(cross(normal, direction())), second = cross(normal, first);
    const double step = 2e-3;
    const auto gap = [&](const Vector3& u) { // even part: no cubic terms
      double sum = 0.0;
      for (const double side : {step, -step})
        sum += sag(shapes[0], normal, side * u) + sag(shapes[1], -normal, side * u);
      return 0.5 * sum / (step * step);
    };
    const double xx = gap(first), yy = gap(second);
    const double xy = gap(std::sqrt(0.5) * (first + second)) - 0.5 * (xx + yy);
    const double mean = 0.5 * (xx + yy), radius = std::hypot(0.5 * (xx - yy), xy);
    EXPECT_NEAR(found.smaller / (mean - radius), 1.0, 3e-3);
    EXPECT_NEAR(found.larger / (mean + radius), 1.0, 3e-3);
  }
}

TEST(RelativeCurvature, MakesTheReducedRadiusOfTheContact) {
  const EllipsoidShape i = make_shape({2.7, 1.6, 1.1}, normalized(Quaternion{0.8, 0.1, -0.5, 0.3}));
  const EllipsoidShape j = make_shape({1.9, 1.4, 0.8}, normalized(Quaternion{0.4, -0.7, 0.2, 0.5}));
  const ContactGeometry contact = find_contact(i, j, {1.6, 1.1, 0.4});
  ASSERT_EQ(contact.status, ContactStatus::touching);
  const RelativeCurvature c = relative_curvature(i, j, contact.normal);
  EXPECT_NEAR(0.5 / std::sqrt(c.smaller * c.larger) / contact.reduced_radius, 1.0, 1e-7);
  const RelativeCurvature wall = relative_curvature(i, contact.normal);
  const ContactGeometry flat = find_plane_contact(i, {0.0, 0.0, 0.0}, contact.normal);
  EXPECT_NEAR(0.5 / std::sqrt(wall.smaller * wall.larger) / flat.reduced_radius, 1.0, 1e-13);
}

} // namespace
