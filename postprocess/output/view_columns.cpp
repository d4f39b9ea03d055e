// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "view_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace ellipsoid::post {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = 3.141592653589793238462643 / 180.0;

/// Places, turns and sizes: shown by the bodies themselves.
bool is_geometry(std::string_view name) {
  constexpr std::array<std::string_view, 35> names = {
      "id",    "type",  "x",     "y",     "z",      "xu",       "yu",        "zu",     "xs",
      "ys",    "zs",    "xsu",   "ysu",   "zsu",    "ix",       "iy",        "iz",     "vx",
      "vy",    "vz",    "quat1", "quat2", "quat3",  "quat4",    "shapex",    "shapey", "shapez",
      "quatw", "quati", "quatj", "quatk", "radius", "diameter", "f_spacing", "element"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string si_unit(const Frame& frame, const std::string& name) {
  if (name == "angle" || name == "tilt")
    return "deg";
  if (!frame.units.empty() && frame.units != "si")
    return "";
  static const std::vector<std::pair<std::string, std::string>> units = {
      {"mass", "kg"},   {"fx", "N"},     {"fy", "N"},         {"fz", "N"},       {"tqx", "N m"},
      {"tqy", "N m"},   {"tqz", "N m"},  {"omegax", "1/s"},   {"omegay", "1/s"}, {"omegaz", "1/s"},
      {"speed", "m/s"}, {"spin", "1/s"}, {"density", "kg/m3"}};
  for (const auto& [known, unit] : units)
    if (known == name)
      return unit;
  return "";
}

/// Direction of the longest semi-axis; zero for spheres.
Vector3 longest_axis(const Particle& p) {
  constexpr double round = 1e-9; ///< axes that differ by less of their size are equal
  const std::array<double, 3> size = {p.semiaxes.x, p.semiaxes.y, p.semiaxes.z};
  const auto [least, most] = std::minmax_element(size.begin(), size.end());
  if (*most - *least <= round * *most)
    return {};
  const Rotation3 turn = rotation(p.orientation);
  const std::array<Vector3, 3> axis = {turn.column_x, turn.column_y, turn.column_z};
  return axis[static_cast<std::size_t>(most - size.begin())];
}

double tilt(const Particle& p, unsigned up) {
  const Vector3 axis = longest_axis(p);
  if (!(norm(axis) > 0.0))
    return no_value;
  return std::acos(std::min(1.0, std::abs(up == 0 ? axis.x : up == 1 ? axis.y : axis.z))) / degree;
}

double angle_in_plane(const Particle& p) {
  const Vector3 axis = longest_axis(p);
  if (!(std::hypot(axis.x, axis.y) > 0.0))
    return no_value;
  const double angle = std::atan2(axis.y, axis.x) / degree;
  return angle < 0.0 ? angle + 180.0 : angle >= 180.0 ? angle - 180.0 : angle;
}

template <typename Value>
ViewColumn column_of(const Frame& frame, const ParticleSet& set, const std::string& name,
                     const Value& value) {
  ViewColumn column{name, si_unit(frame, name), false, {}};
  column.values.reserve(set.particles.size());
  for (const Particle& p : set.particles)
    column.values.push_back(value(p));
  return column;
}

} // namespace

std::vector<ViewColumn> view_columns(const Frame& frame, const ParticleSet& set, unsigned up) {
  std::vector<ViewColumn> columns;
  if (set.has_velocities.is_known()) {
    columns.push_back(
        column_of(frame, set, "speed", [](const Particle& p) { return norm(p.velocity); }));
    if (set.has_spins.is_known())
      columns.push_back(column_of(frame, set, "spin",
                                  [](const Particle& p) { return norm(p.angular_velocity); }));
  }
  columns.push_back(column_of(frame, set, "angle", angle_in_plane));
  columns.back().is_cyclic = true;
  columns.push_back(column_of(frame, set, "tilt", [up](const Particle& p) { return tilt(p, up); }));
  if (set.has_types.fault().empty())
    columns.push_back(column_of(frame, set, "type",
                                [](const Particle& p) { return static_cast<double>(p.type); }));
  for (std::size_t k = 0; k < frame.names.size(); ++k)
    if (!frame.columns[k].empty() && frame.is_readable(k) && !is_geometry(frame.names[k]))
      columns.push_back(column_of(frame, set, frame.names[k],
                                  [&](const Particle& p) { return frame.columns[k][p.row]; }));
  return columns;
}

ColumnRange::ColumnRange(const ViewColumn& column)
    : name_(column.name), unit_(column.unit), is_cyclic_(column.is_cyclic),
      low_(std::numeric_limits<double>::infinity()), high_(-low_) {}

void ColumnRange::add(const std::vector<double>& values) {
  for (const double value : values) {
    if (!std::isfinite(value))
      continue;
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
    are_kinds_ = are_kinds_ && value == std::floor(value);
    if (are_kinds_)
      kinds_.insert(value);
    are_kinds_ = are_kinds_ && kinds_.size() <= most_kinds;
    if (seen_++ % stride_ == 0)
      samples_.push_back(value);
    if (samples_.size() == most_samples) { // every other one is kept from now on
      for (std::size_t k = 0; 2 * k < samples_.size(); ++k)
        samples_[k] = samples_[2 * k];
      samples_.resize(most_samples / 2);
      stride_ *= 2;
    }
  }
}

std::pair<double, double> ColumnRange::shown() const {
  if (is_cyclic_)
    return {0.0, 180.0};
  if (samples_.empty() || !(low_ < high_))
    return {low_, low_ + 1.0};
  std::vector<double> sorted = samples_;
  std::sort(sorted.begin(), sorted.end());
  const double low = sorted[sorted.size() / 100],
               high = sorted[sorted.size() - 1 - sorted.size() / 100];
  return high - low < 0.5 * (high_ - low_) && low < high ? std::pair(low, high)
                                                         : std::pair(low_, high_);
}

std::uint16_t ColumnRange::code_of(double value) const {
  if (!std::isfinite(value))
    return missing;
  if (is_of_kinds())
    return static_cast<std::uint16_t>(std::distance(kinds_.begin(), kinds_.find(value)));
  const double share = high_ > low_ ? (value - low_) / (high_ - low_) : 0.0;
  return static_cast<std::uint16_t>(std::lround(share * largest_code));
}

} // namespace ellipsoid::post
