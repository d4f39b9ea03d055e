// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "particle_colours.h"

#include "colour_map.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ellipsoid::post {
namespace {

constexpr Colour plain_colour{0.78, 0.86, 0.94};

double plane_angle(const Particle& p) {
  const Vector3 axis = p.long_axis();
  const double degrees = std::atan2(axis.y, axis.x) * 180.0 / 3.141592653589793238462643;
  return degrees < 0.0 ? degrees + 180.0 : std::fmod(degrees, 180.0);
}

std::vector<double> values_of(const Frame& frame, const ParticleSet& set, const std::string& by) {
  std::vector<double> values;
  const bool is_column = by != "angle" && by != "speed";
  const std::vector<double>* column =
      is_column ? &frame.required(by, "for the colours; or choose angle or speed") : nullptr;
  if (by == "speed" && !set.has_velocities)
    throw InputError("a file without the columns vx vy vz has no speeds to colour by");
  for (const Particle& p : set.particles)
    values.push_back(column ? (*column)[p.row] : by == "angle" ? plane_angle(p) : norm(p.velocity));
  return values;
}

/// The different values, ascending, where they are few whole numbers; else nothing.
std::vector<double> kinds_of(const std::vector<double>& values) {
  std::set<double> kinds;
  for (const double value : values) {
    if (value != std::floor(value))
      return {};
    kinds.insert(value);
    if (kinds.size() > most_kinds)
      return {};
  }
  return {kinds.begin(), kinds.end()};
}

/// The value below which a share of all lies: strays do not stretch a scale.
double percentile(std::vector<double> values, double share) {
  const auto rank =
      static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

} // namespace

Colour scale_colour(const ParticleColours& scale, double value) {
  if (!scale.kinds.empty()) {
    const auto rank = std::lower_bound(scale.kinds.begin(), scale.kinds.end(), value);
    return kind_colour(static_cast<std::size_t>(rank - scale.kinds.begin()));
  }
  const double width = scale.high - scale.low;
  const double share = width > 0.0 ? (value - scale.low) / width : 0.5;
  return scale.is_cyclic ? cyclic_colour(share) : lighter(colour_of(share), 0.15);
}

ParticleColours particle_colours(const Frame& frame, const ParticleSet& set, const std::string& by,
                                 const std::optional<double>& low,
                                 const std::optional<double>& high) {
  ParticleColours result;
  if (by.empty() || set.particles.empty()) {
    result.colours.assign(set.particles.size(), plain_colour);
    return result;
  }
  const std::vector<double> values = values_of(frame, set, by);
  result.has_scale = true;
  result.is_cyclic = by == "angle";
  result.label = by == "angle"   ? "angle of the long axis [deg]"
                 : by == "speed" ? "speed [m/s]"
                                 : by;
  const bool is_scale = result.is_cyclic || by == "speed" || low || high;
  if (!is_scale)
    result.kinds = kinds_of(values);
  constexpr double stray = 0.01; // share of the particles at either end
  result.low = low.value_or(result.is_cyclic || by == "speed" ? 0.0 : percentile(values, stray));
  result.high = high.value_or(result.is_cyclic ? 180.0 : percentile(values, 1.0 - stray));
  for (const double value : values)
    result.colours.push_back(scale_colour(result, value));
  return result;
}

} // namespace ellipsoid::post
