// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Coarse-graining functions and the fields they make, against numerical integration and closed
// forms.
#include "coarse_graining_function.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

/// Midpoint rule.
double integral(double begin, double end, int parts, const std::function<double(double)>& f) {
  double sum = 0.0;
  for (int k = 0; k < parts; ++k)
    sum += f(begin + (k + 0.5) * (end - begin) / parts);
  return sum * (end - begin) / parts;
}

const CoarseGrainingShape shapes[] = {CoarseGrainingShape::gaussian, CoarseGrainingShape::lucy,
                                      CoarseGrainingShape::heaviside};

TEST(CoarseGrainingFunction, integral_over_space_is_one) {
  for (const CoarseGrainingShape shape : shapes) {
    const CoarseGrainingFunction phi(shape, 0.4);
    const double total = integral(0.0, phi.reach(), 20000,
                                  [&](double r) { return 4.0 * pi * r * r * phi.value(r * r); });
    EXPECT_NEAR(total, 1.0, 1e-7);
    EXPECT_NEAR(phi.between_planes(-9.0, 9.0), 1.0, 1e-12);
    EXPECT_EQ(phi.value(1.0001 * phi.reach() * phi.reach()), 0.0);
  }
}

TEST(CoarseGrainingFunction, values_are_those_of_the_literature) {
  const double w = 0.4, r = 0.5;
  // Weinhart et al. 2012: Gaussian cut off at 3 w; 0.97070911 of it lies inside
  EXPECT_NEAR(CoarseGrainingFunction(CoarseGrainingShape::gaussian, w).value(r * r),
              std::exp(-r * r / (2 * w * w)) / std::pow(std::sqrt(2 * pi) * w, 3) / 0.97070911,
              1e-7);
  // Lucy 1977: 105 / (16 pi c^3) (1 + 3 q) (1 - q)^3, q = r / c
  const double c = 2 * w, q = r / c;
  EXPECT_NEAR(CoarseGrainingFunction(CoarseGrainingShape::lucy, w).value(r * r),
              105 / (16 * pi * c * c * c) * (1 + 3 * q) * std::pow(1 - q, 3), 1e-12);
  EXPECT_NEAR(CoarseGrainingFunction(CoarseGrainingShape::heaviside, w).value(0.1),
              1 / (4.0 / 3.0 * pi * w * w * w), 1e-12);
}

TEST(CoarseGrainingFunction, lines_and_planes_are_integrals_of_the_values) {
  for (const CoarseGrainingShape shape : shapes) {
    const CoarseGrainingFunction phi(shape, 0.4);
    for (const double d : {0.0, 1e-9, 0.1, 0.35, 0.7})
      for (const double begin : {-2.0, -0.2, 0.05})
        for (const double end : {0.1, 0.3, 3.0})
          EXPECT_NEAR(
              phi.along_line(d * d, begin, end),
              integral(begin, end, 200000, [&](double t) { return phi.value(d * d + t * t); }),
              1e-5 / (0.4 * 0.4));
    for (const double z : {0.0, -0.1, 0.25, 0.6, 1.1})
      EXPECT_NEAR(phi.over_plane(z),
                  integral(0.0, phi.reach(), 200000,
                           [&](double r) { return 2.0 * pi * r * phi.value(r * r + z * z); }),
                  1e-4);
    for (const double begin : {-2.0, -0.2, 0.05})
      for (const double end : {-0.3, 0.3, 3.0})
        EXPECT_NEAR(phi.between_planes(begin, end),
                    integral(begin, end, 100000, [&](double z) { return phi.over_plane(z); }),
                    1e-8);
  }
}

} // namespace
} // namespace ellipsoid::post
