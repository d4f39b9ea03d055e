// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ellipsoid::post {

Colour colour_of(double t) {
  // viridis (van der Walt and Smith 2015) at nine equidistant values
  static constexpr std::array<Colour, 9> colours = {{{0.267, 0.005, 0.329},
                                                     {0.279, 0.175, 0.483},
                                                     {0.230, 0.322, 0.546},
                                                     {0.173, 0.449, 0.558},
                                                     {0.128, 0.567, 0.551},
                                                     {0.158, 0.684, 0.502},
                                                     {0.369, 0.789, 0.383},
                                                     {0.678, 0.864, 0.190},
                                                     {0.993, 0.906, 0.144}}};
  const double position = std::clamp(t, 0.0, 1.0) * (colours.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(position), colours.size() - 2);
  const double share = position - static_cast<double>(k);
  const Colour &low = colours[k], &high = colours[k + 1];
  return {low.red + share * (high.red - low.red), low.green + share * (high.green - low.green),
          low.blue + share * (high.blue - low.blue)};
}

namespace {

/// From lightness and the two opponent axes of Oklab (Ottosson 2020) to sRGB.
Colour of_oklab(double lightness, double green_red, double blue_yellow) {
  const auto cubed = [](double x) { return x * x * x; };
  const double l = cubed(lightness + 0.3963377774 * green_red + 0.2158037573 * blue_yellow);
  const double m = cubed(lightness - 0.1055613458 * green_red - 0.0638541728 * blue_yellow);
  const double s = cubed(lightness - 0.0894841775 * green_red - 1.2914855480 * blue_yellow);
  const auto coded = [](double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  };
  return {coded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          coded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          coded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

} // namespace

Colour cyclic_colour(double share) {
  // a circle in the plane of lightness and blue to yellow, which all eyes tell apart: dark, yellow,
  // light, blue
  constexpr double two_pi = 2.0 * 3.141592653589793238462643;
  constexpr double middle = 0.64, lightness_radius = 0.17, hue_radius = 0.13;
  return of_oklab(middle - lightness_radius * std::cos(two_pi * share), 0.0,
                  hue_radius * std::sin(two_pi * share));
}

Colour kind_colour(std::size_t kind) {
  // Okabe and Ito 2008: eight colours that colour-blind readers tell apart, the black one left out
  static constexpr std::array<Colour, most_kinds> colours = {{{0.337, 0.706, 0.914},
                                                              {0.902, 0.624, 0.000},
                                                              {0.000, 0.620, 0.451},
                                                              {0.800, 0.475, 0.655},
                                                              {0.941, 0.894, 0.259},
                                                              {0.000, 0.447, 0.698},
                                                              {0.835, 0.369, 0.000}}};
  return colours[kind % colours.size()];
}

Colour lighter(const Colour& colour, double amount) {
  return {colour.red + amount * (1.0 - colour.red), colour.green + amount * (1.0 - colour.green),
          colour.blue + amount * (1.0 - colour.blue)};
}

} // namespace ellipsoid::post
