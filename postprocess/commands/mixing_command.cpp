// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "body_properties.h"
#include "mixing.h"
#include "option_checks.h"
#include "rows_command.h"
#include "time_option.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

namespace ellipsoid::post {
namespace {

struct MixingCommandOptions {
  FrameOptions frames;
  MixingOptions mixing;
  int type = 0; ///< 0: not given
  bool by_size = false, by_aspect = false, by_volume = false;
  std::string column;
  std::vector<double> region, cell_sizes, scan;
  double time_step = 0.0;
};

/// The numbers that are to be mixed, frame by frame.
class Tracer {
 public:
  explicit Tracer(const MixingCommandOptions& options) : options_(options) {}

  std::string name() const {
    if (options_.type > 0)
      return "type " + std::to_string(options_.type);
    if (options_.by_size)
      return "size";
    if (options_.by_aspect)
      return "aspect ratio";
    return options_.column.empty() ? "region" : options_.column;
  }

  std::vector<double> values(const ChosenFrame& chosen) {
    if (options_.type > 0)
      chosen.set.has_types.require_readable();
    if (!options_.region.empty() && chosen.run != run_)
      mark(chosen);
    std::vector<double> result;
    for (const Particle& p : chosen.set.particles)
      result.push_back(value(chosen, p));
    return result;
  }

 private:
  double value(const ChosenFrame& chosen, const Particle& p) const {
    if (options_.type > 0)
      return p.type == options_.type ? 1.0 : 0.0;
    if (options_.by_size)
      return volume_radius(body_volume(chosen.set, p));
    if (options_.by_aspect)
      return p.largest_axis() / p.smallest_axis();
    if (!options_.column.empty())
      return chosen.frame.required(options_.column, "what is to be mixed")[p.row];
    return marked_.count(p.id) > 0 ? 1.0 : 0.0;
  }

  /// Particles in the region in the first frame of a run.
  void mark(const ChosenFrame& chosen) {
    run_ = chosen.run;
    marked_.clear();
    const std::vector<double>& r = options_.region;
    for (const Particle& p : chosen.set.particles)
      if (p.centre.x >= r[0] && p.centre.x <= r[1] && p.centre.y >= r[2] && p.centre.y <= r[3] &&
          p.centre.z >= r[4] && p.centre.z <= r[5])
        marked_.insert(p.id);
  }

  const MixingCommandOptions& options_;
  std::string run_;
  std::set<std::int64_t> marked_;
};

/// Three diameters of the mean particle: about thirty particles.
double usual_cell(const ParticleSet& set) {
  double sum = 0.0;
  for (const Particle& p : set.particles)
    sum += 2.0 * volume_radius(body_volume(set, p));
  return 3.0 * sum / static_cast<double>(std::max<std::size_t>(1, set.particles.size()));
}

/// As given, or scanned in equal ratios, or the usual one.
std::vector<double> sizes_of_cells(const MixingCommandOptions& options, const ParticleSet& set) {
  if (!options.cell_sizes.empty())
    return options.cell_sizes;
  if (options.scan.empty())
    return {usual_cell(set)};
  const double low = options.scan[0], high = options.scan[1], count = options.scan[2];
  if (!(low > 0.0 && low < high && count >= 2.0 && count <= 1000.0 && count == std::floor(count)))
    throw InputError("--scan needs two sizes in ascending order, > 0, and a whole number of steps "
                     "from 2 to 1000");
  std::vector<double> sizes;
  for (double k = 0.0; k < count; ++k)
    sizes.push_back(low * std::pow(high / low, k / (count - 1.0)));
  return sizes;
}

void append_mixing(Row& row, const Mixing& m) {
  const auto add = [&row](const std::string& key, const std::string& name, double value) {
    row.push_back({key, name, "", value});
  };
  row.push_back({"particles", "particles", "", static_cast<std::int64_t>(m.particles)});
  row.push_back({"cells", "cells with particles", "", static_cast<std::int64_t>(m.cells)});
  add("tracer_mean", "mean of what is mixed", m.mean);
  add("lacey_index", "Lacey's index", m.lacey);
  add("lacey_index_standard_error", "its standard error", m.lacey_error);
  add("segregation_intensity", "intensity of segregation", m.intensity);
  add("segregation_intensity_standard_error", "its standard error, intensity", m.intensity_error);
  add("segregation_intensity_random", "of a random mixture", m.intensity_random);
  add("relative_standard_deviation", "relative standard deviation", m.relative_deviation);
  add("relative_standard_deviation_standard_error", "its standard error, RSD",
      m.relative_deviation_error);
  add("relative_standard_deviation_random", "of a random mixture, RSD",
      m.relative_deviation_random);
  add("relative_standard_deviation_segregated", "of a segregated one, RSD",
      m.relative_deviation_segregated);
  add("gmmi", "generalised mean mixing index", m.mean_position);
  add("gmmi_standard_error", "its error, random mixture", m.mean_position_error);
  add("gmmi_x", "GMMI along x", m.mean_position_x);
  add("gmmi_y", "GMMI along y", m.mean_position_y);
  add("gmmi_z", "GMMI along z", m.mean_position_z);
  add("gmmi_lowest", "GMMI, segregated, at the lower ends", m.mean_position_lowest);
  add("gmmi_highest", "GMMI, segregated, at the upper ends", m.mean_position_highest);
  add("neighbour_index", "index by neighbours", m.neighbour_index);
  add("neighbour_index_standard_error", "its standard error, neighbours", m.neighbour_index_error);
  add("variance", "variance of the cells", m.variance);
  add("variance_random", "variance, random mixture", m.variance_random);
  add("variance_segregated", "variance, segregated", m.variance_segregated);
}

std::vector<Row> mixing_rows(const MixingCommandOptions& options, Tracer& tracer,
                             const ChosenFrame& chosen) {
  const std::vector<double> values = tracer.values(chosen);
  const PeriodicCell cell(chosen.set.box);
  std::vector<double> volumes;
  for (const Particle& p : chosen.set.particles)
    if (options.by_volume)
      volumes.push_back(body_volume(chosen.set, p));
  std::vector<Row> rows;
  for (const double size : sizes_of_cells(options, chosen.set)) {
    MixingOptions settings = options.mixing;
    settings.weights = volumes;
    settings.cell_size = size;
    Row row = frame_row(chosen);
    append_time(row, chosen.frame, options.time_step);
    row.push_back({"tracer", "what is mixed", "", tracer.name()});
    row.push_back({"counted_by", "particles count by", "",
                   std::string(options.by_volume ? "volume" : "number")});
    row.push_back({"cell_m", "size of the cells", "m", size});
    append_mixing(row, mixing(chosen.set, values, cell, settings));
    rows.push_back(std::move(row));
  }
  return rows;
}

void add_tracer_options(CLI::App& command, MixingCommandOptions& options) {
  CLI::Option_group* tracer = command.add_option_group("what is mixed");
  tracer->add_option("--type", options.type, "particles of this type against all others")
      ->check(CLI::Range(1, 1000000));
  tracer->add_flag("--size", options.by_size, "radius of the ball of a particle's volume");
  tracer->add_flag("--aspect", options.by_aspect, "longest over shortest semi-axis");
  tracer->add_option("--value", options.column, "a column of the dump");
  tracer
      ->add_option("--region", options.region,
                   "x0 x1 y0 y1 z0 z1: particles that were there in the first frame")
      ->expected(6);
  tracer->require_option(1);
}

void add_cell_options(CLI::App& command, MixingCommandOptions& options) {
  auto* cell = command.add_option(
      "--cell", options.cell_sizes,
      "size of the cubic cells (m), several: one row each (default: 3 mean diameters)");
  cell->check(CLI::PositiveNumber);
  command
      .add_option("--scan", options.scan,
                  "smallest and largest size of the cells (m) and the number of sizes, in equal "
                  "ratios: one row each")
      ->expected(3)
      ->excludes(cell);
}

} // namespace

void add_mixing_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<MixingCommandOptions>();
  CLI::App* command = program.add_subcommand(
      "mixing", "indices of mixing and segregation, with bounds and standard errors");
  command->footer(
      "q is 1 for the tracer and 0 for others, or a size. S^2: variance of the means of q in "
      "cells, weighted by their numbers of particles; S0^2: of q itself (segregated); SR^2 = S0^2 "
      "(C - 1) / (N - 1) with C cells and N particles: its mean over all orders. Lacey (S0^2 - "
      "S^2) / (S0^2 - SR^2); intensity S^2 / S0^2; relative standard deviation S / mean; GMMI: "
      "mean position of q over that of all from the lowest particle; neighbours: mean (q_i - "
      "q_k)^2 over that of a random order.");
  add_frame_options(*command, options->frames, FrameUse::table);
  add_time_option(*command, options->time_step);
  add_tracer_options(*command, *options);
  add_cell_options(*command, *options);
  command->add_flag("--by-volume", options->by_volume,
                    "particles count by their volumes, not all alike");
  command->add_option("--neighbours", options->mixing.neighbours, "nearest ones of each particle")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->callback([command, options, &exit_code] {
    const bool is_marked = !options->region.empty(); // in the first frame, for those that follow
    if (is_marked)
      refuse_without_effect(*command, {"--threads"}, "with --region");
    require_ascending_pairs("--region", options->region, EqualBounds::allowed);
    Tracer tracer_of_run(*options);
    exit_code = run_rows_command(
        options->frames, "Mixing", is_marked ? FrameOrder::ascending : FrameOrder::any,
        [&](const ChosenFrame& f) { return mixing_rows(*options, tracer_of_run, f); });
  });
}

} // namespace ellipsoid::post
