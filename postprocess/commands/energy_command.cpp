// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "energy.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "gravity_options.h"
#include "measure_rows.h"
#include "messages.h"
#include "table_command.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace ellipsoid::post {
namespace {

struct EnergyCommandOptions {
  FrameOptions frames;
  std::vector<double> gravity, inertia;
};

template <class Number> Value known(const std::optional<Number>& number) {
  return number ? Value(*number) : Value();
}

Row energy_row(const EnergyCommandOptions& options, const ChosenFrame& chosen) {
  const Gravity gravity = gravity_of(options.gravity, chosen);
  EnergyOptions settings;
  settings.gravity = gravity.vector;
  if (options.inertia.size() == 3)
    settings.inertia = Vector3{options.inertia[0], options.inertia[1], options.inertia[2]};
  const Energy e = energy(chosen.set, settings);
  if (!gravity.vector && !chosen.set.particles.empty())
    report_warning(chosen.run +
                       ": no potential energy: where gravity points is neither in a log beside "
                       "the dump nor given by --gravity gx gy gz",
                   "gravity of " + chosen.run);
  if (!e.rotation)
    report_warning(chosen.run +
                       ": no energy of rotation: the file has no columns omegax omegay omegaz",
                   "spins of " + chosen.run);
  const auto& particles = chosen.set.particles;
  if (e.rotation && !settings.inertia && !chosen.set.has_moments &&
      std::any_of(particles.begin(), particles.end(),
                  [](const Particle& p) { return p.is_host_body && p.sphere_count > 1; }))
    report_warning(chosen.run +
                       ": moments of inertia of the host's bodies are not in the file: taken are "
                       "those of the solid ellipsoid around a chain, of the union of the spheres "
                       "else; give others by --inertia",
                   "moments of " + chosen.run);
  Row row = frame_row(chosen);
  row.push_back(
      {"particles", "particles", "", static_cast<std::int64_t>(chosen.set.particles.size())});
  row.push_back({"translation_J", "kinetic, translation", "J", e.translation});
  row.push_back({"rotation_J", "kinetic, rotation", "J", known(e.rotation)});
  row.push_back({"potential_J", "potential, gravity", "J", known(e.potential)});
  append_gravity(row, gravity);
  append_rest(row, check_rest(chosen.set, all_members(chosen.set), gravity.magnitude));
  return row;
}

} // namespace

void add_energy_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<EnergyCommandOptions>();
  options->frames.frames = "all";
  CLI::App* command = program.add_subcommand("energy", "energies over time and rest check");
  command->footer(
      "Translation: sum of m v^2 / 2. Rotation: sum of w.(I w) / 2 with w in the body's axes and "
      "I1 = m (b^2 + c^2) / 5 and so on (the solid ellipsoid), or of the columns inertiax inertiay "
      "inertiaz, or --inertia for all particles. "
      "Potential: -sum of m g.x. At rest: every point slower than 0.01 sqrt(g b).");
  add_frame_options(*command, options->frames, FrameUse::table);
  add_gravity_option(*command, options->gravity);
  command
      ->add_option("--inertia", options->inertia,
                   "principal moments about the body's x, y, z (kg m2)")
      ->expected(3)
      ->check(CLI::PositiveNumber);
  command->callback([options, &exit_code] {
    exit_code = run_table_command(options->frames, "Energy",
                                  [&](const ChosenFrame& f) { return energy_row(*options, f); });
  });
}

} // namespace ellipsoid::post
