// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "gravity_options.h"

#include "run_state.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// @param[in] option that says it where the log does not
std::optional<Vector3> logged_gravity(const ChosenFrame& chosen, const char* option) {
  const RunLog* log = log_of(chosen);
  if (log && !log->untold_gravity.empty())
    throw InputError(fmt::format("{} does not tell gravity (\"{}\"): say it by {}", log->path,
                                 log->untold_gravity, option));
  return log ? log->gravity : std::nullopt;
}

/// Whether all particles lie in one plane z and stay there: a single one that falls along z, or a
/// layer of them, does not.
bool is_planar(const ParticleSet& set) {
  const auto stays = [&set](const Particle& p) {
    const bool is_moving = set.has_velocities.is_known() && p.velocity.z != 0.0;
    const bool is_tilting =
        set.has_spins.is_known() && (p.angular_velocity.x != 0.0 || p.angular_velocity.y != 0.0);
    return p.centre.z == set.particles.front().centre.z && !is_moving && !is_tilting;
  };
  return !set.particles.empty() && std::all_of(set.particles.begin(), set.particles.end(), stays);
}

} // namespace

void add_gravity_option(CLI::App& command, std::vector<double>& gravity) {
  command
      .add_option(
          "--gravity", gravity,
          "gx gy gz, or its magnitude alone (m/s2); default: of the log beside the dump, else "
          "9.81, for particles in a plane z along -y")
      ->expected(1, 3);
}

Gravity gravity_of(const std::vector<double>& option, const ChosenFrame& chosen) {
  if (option.size() == 2)
    throw InputError("--gravity takes gx gy gz, or the magnitude alone");
  Gravity gravity;
  const bool is_whole = option.size() == 3;
  const std::optional<Vector3> logged =
      is_whole ? std::nullopt : logged_gravity(chosen, "--gravity gx gy gz");
  const bool is_plane = is_planar(chosen.set);
  gravity.source = !option.empty() ? "option" : logged ? "log" : "assumed";
  if (is_whole)
    gravity.vector = Vector3{option[0], option[1], option[2]};
  else if (option.size() == 1 && logged && norm(*logged) > 0.0)
    gravity.vector = option[0] * normalized(*logged);
  else if (option.size() == 1)
    gravity.magnitude = option[0];
  else
    gravity.vector = logged;
  if (!gravity.vector && is_plane)
    gravity.vector = Vector3{0.0, -gravity.magnitude, 0.0};
  if (gravity.vector)
    gravity.magnitude = norm(*gravity.vector);
  if (!(gravity.magnitude >= 0.0) || !std::isfinite(gravity.magnitude))
    throw InputError("--gravity must be a finite vector, or a magnitude >= 0");
  return gravity;
}

void append_gravity(Row& row, const Gravity& gravity) {
  const auto component = [&gravity](double Vector3::*axis) {
    return gravity.vector ? Value((*gravity.vector).*axis) : Value();
  };
  row.push_back({"gravity_x_m_per_s2", "gravity: x", "m/s2", component(&Vector3::x)});
  row.push_back({"gravity_y_m_per_s2", "gravity: y", "m/s2", component(&Vector3::y)});
  row.push_back({"gravity_z_m_per_s2", "gravity: z", "m/s2", component(&Vector3::z)});
  row.push_back({"gravity_from", "gravity from", "", gravity.source});
}

void add_up_option(CLI::App& command, std::string& up) {
  command
      .add_option("--up", up,
                  "axis that points up: y or z (with y, the plan's x is the file's z and its y the "
                  "file's x); default: against gravity of the log beside the dump, else z")
      ->check(CLI::IsMember({"y", "z"}));
}

UpDirection up_direction(const std::string& option, const ChosenFrame& chosen) {
  if (!option.empty())
    return {option == "y" ? UpAxis::y : UpAxis::z, "option"};
  const std::optional<Vector3> gravity = logged_gravity(chosen, "--up y or --up z");
  if (!gravity || !(norm(*gravity) > 0.0))
    return {UpAxis::z, "assumed"};
  constexpr double nearly = 0.999; // cosine
  const Vector3 up = -normalized(*gravity);
  if (up.y > nearly || up.z > nearly)
    return {up.y > nearly ? UpAxis::y : UpAxis::z, "log"};
  throw InputError(
      fmt::format("gravity of the run's log, {:.4g} {:.4g} {:.4g}, is along neither -y nor "
                  "-z: say --up y or --up z",
                  gravity->x, gravity->y, gravity->z));
}

void append_up(Row& row, const UpDirection& up) {
  row.push_back({"up", "axis that points up", "", std::string(up.axis == UpAxis::y ? "y" : "z")});
  row.push_back({"up_from", "axis from", "", up.source});
}

} // namespace ellipsoid::post
