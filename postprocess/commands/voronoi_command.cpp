// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "body_properties.h"
#include "messages.h"
#include "particle_values.h"
#include "rows_command.h"
#include "set_voronoi.h"
#include "spread.h"
#include "time_option.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

struct VoronoiCommandOptions {
  FrameOptions frames;
  SetVoronoiOptions cells;
  std::vector<double> box;
  std::string per_particle;
  double time_step = 0.0;
};

/// The box of the frame; along axes that do not repeat it may be given.
PeriodicCell cell_of(const VoronoiCommandOptions& options, const Box& frame_box) {
  Box box = frame_box;
  const PeriodicCell whole(box);
  if (!options.box.empty() && whole.is_periodic(0) && whole.is_periodic(1) && whole.is_periodic(2))
    throw InputError("--box is for axes that do not repeat; this box repeats along all: leave it "
                     "out");
  for (std::size_t k = 0; k < 3 && !options.box.empty(); ++k) {
    if (whole.is_periodic(k))
      continue;
    box.lower[k] = options.box[2 * k];
    box.upper[k] = options.box[2 * k + 1];
    if (!(box.lower[k] < box.upper[k]))
      throw InputError("--box needs x0 < x1, y0 < y1 and z0 < z1");
  }
  return PeriodicCell(box);
}

std::vector<ParticleValues> particle_values(const std::vector<SetVoronoiCell>& cells) {
  std::vector<ParticleValues> columns{{"cell_volume_m3", {}},   {"cell_area_m2", {}},
                                      {"packing_fraction", {}}, {"cell_neighbours", {}},
                                      {"cell_anisotropy", {}},  {"cell_ends_at_box", {}}};
  for (const SetVoronoiCell& c : cells) {
    const double values[] = {c.volume,           c.area,
                             c.packing_fraction, static_cast<double>(c.neighbours),
                             c.anisotropy,       c.is_bounded_by_box ? 1.0 : 0.0};
    for (std::size_t k = 0; k < columns.size(); ++k)
      columns[k].values.push_back(values[k]);
  }
  return columns;
}

void append_spread(Row& row, const std::vector<double>& values, const std::string& key,
                   const std::string& name) {
  const Spread s = spread_of(values);
  const bool is_known = s.count > 0;
  row.push_back({key + "_mean", name + ", mean", "", is_known ? Value(s.mean) : Value()});
  row.push_back({key + "_standard_deviation", name + ", standard deviation", "",
                 is_known ? Value(s.standard_deviation) : Value()});
}

/// Bodies count whole, whatever of them lies in others.
void warn_of_overlaps(const ChosenFrame& chosen, const std::vector<SetVoronoiCell>& cells) {
  const auto count = std::count_if(cells.begin(), cells.end(), [](const SetVoronoiCell& cell) {
    return cell.packing_fraction > 1.0;
  });
  if (count > 0)
    report_warning(fmt::format("{}: time step {}: {} bodies overlap so far with others that they "
                               "are larger than their cells: packing fractions above 1",
                               chosen.run, chosen.frame.timestep, count));
}

Row voronoi_row(const VoronoiCommandOptions& options, const ChosenFrame& chosen) {
  const PeriodicCell box = cell_of(options, chosen.set.box);
  const std::vector<SetVoronoiCell> cells = set_voronoi(chosen.set, box, options.cells);
  warn_of_overlaps(chosen, cells);
  if (!options.per_particle.empty())
    write_particle_values(options.per_particle, chosen, particle_values(cells));
  std::vector<double> fractions, neighbours, anisotropies;
  double solid = 0.0, total = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    solid += cells[i].packing_fraction * cells[i].volume;
    total += cells[i].volume;
    if (cells[i].is_bounded_by_box)
      continue;
    fractions.push_back(cells[i].packing_fraction);
    neighbours.push_back(static_cast<double>(cells[i].neighbours));
    anisotropies.push_back(cells[i].anisotropy);
  }
  Row row = frame_row(chosen);
  append_time(row, chosen.frame, options.time_step);
  const auto whole = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  row.push_back({"particles", "particles", "", whole(cells.size())});
  row.push_back({"inner_cells", "cells that do not end at the box", "", whole(fractions.size())});
  row.push_back({"cell_volume_sum_m3", "volume of all cells", "m3", total});
  row.push_back({"packing_fraction", "packing fraction of all cells", "", solid / total});
  append_spread(row, fractions, "local_packing_fraction", "local packing fraction");
  append_spread(row, neighbours, "cell_neighbours", "neighbours of a cell");
  append_spread(row, anisotropies, "cell_anisotropy", "anisotropy of a cell");
  return row;
}

} // namespace

void add_voronoi_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<VoronoiCommandOptions>();
  CLI::App* command = program.add_subcommand(
      "voronoi", "Set-Voronoi cells: local packing fraction, neighbours, anisotropy");
  command->footer(
      "The Set-Voronoi cell of a particle: the points nearer to its surface than to that of any "
      "other (Schaller et al. 2013), from the Voronoi cells of points on the surfaces. Equal "
      "spheres: ordinary cells. Anisotropy: smallest over largest eigenvalue of the integral of n "
      "n over the cell's surface. Means are over cells that do not end at the box.");
  add_frame_options(*command, options->frames, FrameUse::table);
  add_time_option(*command, options->time_step);
  command
      ->add_option("--spacing-on-surface", options->cells.spacing,
                   "distance of the points, in mean radii of balls of the particles' volumes")
      ->check(CLI::Range(0.02, 1.0))
      ->capture_default_str();
  command
      ->add_option("--box", options->box,
                   "x0 x1 y0 y1 z0 z1: ends of the cells along axes that do not repeat")
      ->expected(6);
  add_particle_values_option(*command, options->per_particle);
  command->callback([options, &exit_code] {
    exit_code = run_rows_command(
        options->frames, "Set-Voronoi cells", FrameOrder::any,
        [&](const ChosenFrame& f) { return std::vector<Row>{voronoi_row(*options, f)}; });
  });
}

} // namespace ellipsoid::post
