// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "bed.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "gravity_options.h"
#include "heap.h"
#include "measure_rows.h"
#include "messages.h"
#include "porosity_value.h"
#include "table_command.h"

#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

struct HeapCommandOptions {
  FrameOptions frames;
  HeapOptions heap;
  std::string up;
  int planes = 200;
};

/// A bed in a dish has an edge, and no angle of repose.
void warn_of_flat_top(const std::string& run, const HeapAngle& heap, const HeapOptions& options) {
  const double of_cone = 1.0 - options.cut_top / (1.0 - options.cut_bottom);
  if (heap.line_share < 0.5 * of_cone)
    report_warning(
        fmt::format("{}: the line goes over {:.0f} % of the heap's radius, in a cone over "
                    "{:.0f} %: the heap is flat on top, and the angle is that of its edge",
                    run, 100.0 * heap.line_share, 100.0 * of_cone));
}

Row heap_row(const HeapCommandOptions& options, const ChosenFrame& chosen) {
  const UpDirection up = up_direction(options.up, chosen);
  const ParticleSet set = turned_upright(chosen.set, up.axis);
  const HeapAngle heap = heap_angle(set, options.heap);
  warn_of_flat_top(chosen.run, heap, options.heap);
  const auto members = largest_cluster(set, options.heap.cluster_gap);
  Row row = frame_row(chosen);
  append_surface(row, set);
  append_up(row, up);
  row.push_back(
      {"particles", "particles of the heap", "", static_cast<std::int64_t>(heap.members)});
  row.push_back(
      {"strays", "particles outside the heap", "", static_cast<std::int64_t>(heap.strays)});
  row.push_back({"heap_height_m", "height", "m", heap.height});
  row.push_back({"axis_x_m", "axis: x", "m", heap.axis_x});
  row.push_back({"axis_y_m", "axis: y", "m", heap.axis_y});
  row.push_back({"repose_angle_deg", "angle of repose", "deg", heap.spread.mean});
  row.push_back({"repose_angle_standard_error_deg", "standard error", "deg", heap.standard_error});
  row.push_back({"repose_angle_sector_deviation_deg", "standard deviation over sectors", "deg",
                 heap.spread.standard_deviation});
  row.push_back({"repose_angle_lowest_sector_deg", "lowest sector", "deg", heap.spread.lowest});
  row.push_back({"repose_angle_highest_sector_deg", "highest sector", "deg", heap.spread.highest});
  row.push_back({"heap_volume_m3", "volume below the surface", "m3", heap.volume});
  row.push_back(
      {"porosity", "porosity", "",
       porosity_of(solid_volume(set, members, options.planes, options.heap.floor), heap.volume)});
  return row;
}

void add_cone_options(CLI::App& command, HeapCommandOptions& options) {
  command.add_option("--floor", options.heap.floor, "height of the floor")->capture_default_str();
  command.add_option("--sectors", options.heap.sectors, "number of sectors")
      ->check(CLI::Range(1, 360))
      ->capture_default_str();
  command.add_option("--cut-bottom", options.heap.cut_bottom, "as for pile")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  command.add_option("--cut-top", options.heap.cut_top, "as for pile")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  command.add_option("--columns", options.heap.column_width, "width of the columns, in b")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  command.add_option("--cluster-gap", options.heap.cluster_gap, "as for pile, in b")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  command.add_option("--planes", options.planes, "planes of the volume's integration")
      ->check(CLI::Range(8, 100000))
      ->capture_default_str();
}

} // namespace

void add_heap_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<HeapCommandOptions>();
  CLI::App* command =
      program.add_subcommand("heap", "angle of repose and porosity of a free 3D heap (cone)");
  command->footer(
      "Heap: the largest cluster of particles connected as in `pile`. Free surface: z_max(x, y) of "
      "the true outlines at the middles of square columns 0.25 b wide (--columns). Axis: centroid "
      "of the volume under the surface. In each of --sectors equal sectors, rings as wide as the "
      "mean largest semi-axis give a radial profile of mean heights; H is the largest ring mean "
      "over all sectors; the least squares line goes from the outermost ring >= (1 - cut_top) H to "
      "the outermost >= cut_bottom H. The angle is the mean of atan(-slope) over sectors, its "
      "standard error the deviation over sectors / sqrt(sectors).\n"
      "Porosity: 1 - V_solid / V, V between floor and free surface, V_solid the union of all "
      "particles, from exact sections in --planes planes.");
  add_frame_options(*command, options->frames, FrameUse::table);
  add_up_option(*command, options->up);
  add_cone_options(*command, *options);
  command->callback([options, &exit_code] {
    exit_code = run_table_command(options->frames, "Heap",
                                  [&](const ChosenFrame& f) { return heap_row(*options, f); });
  });
}

} // namespace ellipsoid::post
