// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "energy.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "measure_rows.h"
#include "table_command.h"

#include <memory>

namespace ellipsoid::post {
namespace {

struct EnergyCommandOptions {
  FrameOptions frames;
  EnergyOptions energy;
};

Row energy_row(const EnergyCommandOptions& options, const ChosenFrame& chosen) {
  const Energy e = energy(chosen.set, options.energy);
  Row row = frame_row(chosen);
  row.push_back(
      {"particles", "particles", "", static_cast<std::int64_t>(chosen.set.particles.size())});
  row.push_back({"translation_J", "kinetic, translation", "J", e.translation});
  row.push_back({"rotation_J", "kinetic, rotation", "J", e.rotation});
  row.push_back({"potential_J", "potential, gravity", "J", e.potential});
  append_rest(row, check_rest(chosen.set, all_members(chosen.set), norm(options.energy.gravity)));
  return row;
}

} // namespace

void add_energy_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<EnergyCommandOptions>();
  options->frames.frames = "all";
  auto gravity = std::make_shared<std::vector<double>>(std::vector<double>{0.0, -9.81, 0.0});
  auto inertia = std::make_shared<std::vector<double>>();
  CLI::App* command = program.add_subcommand("energy", "energies over time and rest check");
  command->footer(
      "Translation: sum of m v^2 / 2. Rotation: sum of w.(I w) / 2 with w in the body's axes and "
      "I1 = m (b^2 + c^2) / 5 and so on (the solid ellipsoid), or --inertia for all particles. "
      "Potential: -sum of m g.x. At rest: every point slower than 0.01 sqrt(g b).");
  add_frame_options(*command, options->frames);
  command->add_option("--gravity", *gravity, "gx gy gz (m/s2)")->expected(3);
  command->add_option("--inertia", *inertia, "principal moments about the body's x, y, z (kg m2)")
      ->expected(3)
      ->check(CLI::PositiveNumber);
  command->callback([options, gravity, inertia, &exit_code] {
    options->energy.gravity = {(*gravity)[0], (*gravity)[1], (*gravity)[2]};
    if (inertia->size() == 3)
      options->energy.inertia = Vector3{(*inertia)[0], (*inertia)[1], (*inertia)[2]};
    exit_code = run_table_command(options->frames, "Energy",
                                  [&](const ChosenFrame& f) { return energy_row(*options, f); });
  });
}

} // namespace ellipsoid::post
