// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ellipsoid::post {

Colour colour_of(double t) {
  // viridis (van der Walt and Smith 2015) at nine equidistant places
  static constexpr std::array<Colour, 9> places = {{{0.267, 0.005, 0.329},
                                                    {0.279, 0.175, 0.483},
                                                    {0.230, 0.322, 0.546},
                                                    {0.173, 0.449, 0.558},
                                                    {0.128, 0.567, 0.551},
                                                    {0.158, 0.684, 0.502},
                                                    {0.369, 0.789, 0.383},
                                                    {0.678, 0.864, 0.190},
                                                    {0.993, 0.906, 0.144}}};
  const double place = std::clamp(t, 0.0, 1.0) * (places.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(place), places.size() - 2);
  const double share = place - static_cast<double>(k);
  const Colour &low = places[k], &high = places[k + 1];
  return {low.red + share * (high.red - low.red), low.green + share * (high.green - low.green),
          low.blue + share * (high.blue - low.blue)};
}

Colour cyclic_colour(double share) {
  constexpr double two_pi = 2.0 * 3.141592653589793238462643;
  const auto wave = [&](double phase) { return 0.62 + 0.30 * std::cos(two_pi * (share - phase)); };
  return {wave(0.0), wave(1.0 / 3.0), wave(2.0 / 3.0)};
}

Colour lighter(const Colour& colour, double amount) {
  return {colour.red + amount * (1.0 - colour.red), colour.green + amount * (1.0 - colour.green),
          colour.blue + amount * (1.0 - colour.blue)};
}

} // namespace ellipsoid::post
