// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_loop.h"
#include "frame_options.h"
#include "measure_rows.h"
#include "orientation.h"
#include "table_command.h"

#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

struct OrientationOptions {
  FrameOptions frames;
  int bins = 18;
};

Row orientation_row(const OrientationOptions& options, const ChosenFrame& chosen) {
  if (chosen.set.particles.empty())
    throw InputError("there are no particles");
  const Orientation o = orientation(chosen.set, all_members(chosen.set), options.bins);
  Row row = frame_row(chosen);
  append_surface(row, chosen.set);
  row.push_back({"nematic_order", "nematic order S", "", o.nematic_order});
  row.push_back({"director_x", "director: x", "", o.director.x});
  row.push_back({"director_y", "director: y", "", o.director.y});
  row.push_back({"director_z", "director: z", "", o.director.z});
  row.push_back({"plane_order", "order in the plane S2", "", o.plane_order});
  row.push_back({"plane_angle_deg", "director's angle in the plane", "deg", o.plane_angle_deg});
  append_rose(row, o.rose);
  return row;
}

} // namespace

void add_orientation_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<OrientationOptions>();
  CLI::App* command =
      program.add_subcommand("orientation", "nematic order and angle rose of the long axes");
  command->footer(
      "n: a particle's long axis, that of its largest semi-axis wherever it is in the body (of two "
      "or three equal ones the first). S: largest eigenvalue of Q = <3/2 (n n - I/3)>, director "
      "its "
      "eigenvector. S2 = |<exp(2 i theta)>|, theta the angle of n in the xy plane; the plane's "
      "director is half the phase. Rose: share of particles per bin of theta from 0 to 180 deg.");
  add_frame_options(*command, options->frames);
  command->add_option("--bins", options->bins, "bins of the rose")
      ->check(CLI::Range(1, 360))
      ->capture_default_str();
  command->callback([options, &exit_code] {
    exit_code = run_table_command(options->frames, "Orientation", [&](const ChosenFrame& f) {
      return orientation_row(*options, f);
    });
  });
}

} // namespace ellipsoid::post
