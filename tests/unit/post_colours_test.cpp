// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Colours that colour-blind readers tell apart: distances in CIELAB after the simulation of
// deuteranopia and protanopia by Machado, Oliveira and Fernandes (2009), severity 1.
#include "colour_map.h"

#include <cmath>
#include <gtest/gtest.h>

namespace ellipsoid::post {
namespace {

using Matrix = double[3][3];
constexpr Matrix nothing = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr Matrix deuteranopia = {{0.367322, 0.860646, -0.227968},
                                 {0.280085, 0.672501, 0.047413},
                                 {-0.011820, 0.042940, 0.968881}};
constexpr Matrix protanopia = {{0.152286, 1.052583, -0.204868},
                               {0.114503, 0.786281, 0.099216},
                               {-0.003882, -0.048116, 1.051998}};

double linear(double coded) {
  return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

struct Lab {
  double l, a, b;
};

/// As a reader sees a colour (D65).
Lab seen(const Colour& colour, const Matrix& eye) {
  const double in[3] = {linear(colour.red), linear(colour.green), linear(colour.blue)};
  double rgb[3];
  for (int k = 0; k < 3; ++k)
    rgb[k] =
        std::fmin(1.0, std::fmax(0.0, eye[k][0] * in[0] + eye[k][1] * in[1] + eye[k][2] * in[2]));
  const double x = (0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.95047;
  const double y = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  const double z = (0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.08883;
  const auto f = [](double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  };
  return {116.0 * f(y) - 16.0, 500.0 * (f(x) - f(y)), 200.0 * (f(y) - f(z))};
}

double distance(const Lab& p, const Lab& q) {
  return std::sqrt((p.l - q.l) * (p.l - q.l) + (p.a - q.a) * (p.a - q.a) +
                   (p.b - q.b) * (p.b - q.b));
}

TEST(CyclicColours, angles_20_degrees_apart_are_told_apart_by_every_eye) {
  constexpr double noticeable = 2.3; // Mahy et al. 1994
  for (const Matrix* eye : {&nothing, &deuteranopia, &protanopia})
    for (int first = 0; first < 180; first += 5)
      for (int second = first + 20; second <= first + 160; second += 5) {
        const double d = distance(seen(cyclic_colour(first / 180.0), *eye),
                                  seen(cyclic_colour(second / 180.0), *eye));
        EXPECT_GT(d, 3.0 * noticeable) << first << " and " << second;
      }
}

TEST(CyclicColours, close_up_and_are_even) {
  const Colour begin = cyclic_colour(0.0), end = cyclic_colour(1.0);
  EXPECT_NEAR(begin.red, end.red, 1e-12);
  EXPECT_NEAR(begin.blue, end.blue, 1e-12);
  double least = 1e300, most = 0.0;
  for (int k = 0; k < 90; ++k) {
    const double step = distance(seen(cyclic_colour(k / 90.0), nothing),
                                 seen(cyclic_colour((k + 1) / 90.0), nothing));
    least = std::fmin(least, step);
    most = std::fmax(most, step);
  }
  EXPECT_LT(most, 3.0 * least);
}

TEST(KindColours, are_told_apart_by_every_eye) {
  for (const Matrix* eye : {&nothing, &deuteranopia, &protanopia})
    for (std::size_t first = 0; first < most_kinds; ++first)
      for (std::size_t second = first + 1; second < most_kinds; ++second)
        EXPECT_GT(distance(seen(kind_colour(first), *eye), seen(kind_colour(second), *eye)), 7.0)
            << first << " and " << second;
}

TEST(ScaleColours, grow_lighter_evenly) {
  double before = -1.0;
  for (int k = 0; k <= 20; ++k) {
    const double lightness = seen(colour_of(k / 20.0), nothing).l;
    EXPECT_GT(lightness, before);
    before = lightness;
  }
}

} // namespace
} // namespace ellipsoid::post
