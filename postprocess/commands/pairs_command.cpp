// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "body_properties.h"
#include "pair_distributions.h"
#include "rows_command.h"
#include "time_option.h"

#include <algorithm>
#include <memory>

namespace ellipsoid::post {
namespace {

struct PairsOptions {
  FrameOptions frames;
  double farthest = 0.0, gap = 0.0, lowest_gap = 0.0, wave_number = 0.0, time_step = 0.0;
  int bins = 100;
};

Row beginning(const PairsOptions& options, const ChosenFrame& chosen) {
  Row row = frame_row(chosen);
  append_time(row, chosen.frame, options.time_step);
  return row;
}

/// Four diameters, if the box is large enough.
double usual_distance(const ParticleSet& set, const PeriodicCell& cell) {
  double sum = 0.0;
  for (const Particle& p : set.particles)
    sum += 8.0 * volume_radius(body_volume(set, p));
  const double four_diameters =
      sum / static_cast<double>(std::max<std::size_t>(1, set.particles.size()));
  return set.particles.size() < 2 ? four_diameters
                                  : std::min(four_diameters, largest_pair_distance(set, cell));
}

std::vector<Row> distance_rows(const PairsOptions& options, const ChosenFrame& chosen) {
  const PeriodicCell cell(chosen.set.box);
  const double farthest =
      options.farthest > 0.0 ? options.farthest : usual_distance(chosen.set, cell);
  std::vector<Row> rows;
  for (const DistanceBin& bin : pair_distribution(chosen.set, cell, farthest, options.bins)) {
    Row row = beginning(options, chosen);
    row.push_back({"distance_m", "distance", "m", 0.5 * (bin.begin + bin.end)});
    row.push_back({"g", "g(r)", "", bin.g});
    row.push_back({"g2", "g2(r)", "", bin.g2 ? Value(*bin.g2) : Value()});
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Row> gap_rows(const PairsOptions& options, const ChosenFrame& chosen) {
  if (!(options.lowest_gap < options.gap))
    throw InputError("--lowest-gap must lie below --gap");
  std::vector<Row> rows;
  for (const GapBin& bin : gap_distribution(chosen.set, PeriodicCell(chosen.set.box),
                                            options.lowest_gap, options.gap, options.bins)) {
    Row row = beginning(options, chosen);
    row.push_back({"gap_m", "gap", "m", 0.5 * (bin.begin + bin.end)});
    row.push_back({"gap_density_per_m", "neighbours per particle and gap", "1/m", bin.density});
    row.push_back({"neighbours", "neighbours per particle up to here", "", bin.neighbours});
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Row> structure_rows(const PairsOptions& options, const ChosenFrame& chosen) {
  std::vector<Row> rows;
  for (const StructureBin& bin : structure_factor(chosen.set, PeriodicCell(chosen.set.box),
                                                  options.wave_number, options.bins)) {
    if (bin.vectors == 0)
      continue;
    Row row = beginning(options, chosen);
    row.push_back({"wave_number_per_m", "wave number", "1/m", bin.wave_number});
    row.push_back({"structure_factor", "S(k)", "", bin.s});
    row.push_back({"wave_vectors", "wave vectors", "", static_cast<std::int64_t>(bin.vectors)});
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Row> pair_rows(const PairsOptions& options, const ChosenFrame& chosen) {
  if (options.wave_number > 0.0)
    return structure_rows(options, chosen);
  return options.gap > 0.0 ? gap_rows(options, chosen) : distance_rows(options, chosen);
}

} // namespace

void add_pairs_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<PairsOptions>();
  CLI::App* command = program.add_subcommand(
      "pairs", "pair distribution g(r) and g2(r), distribution of gaps, structure factor");
  command->footer(
      "g(r): pairs of centres over those of an ideal gas in the same region. g2(r): mean of P2(u_i "
      ". u_j), u along the longest semi-axis, of discs along the shortest. --gap: exact gaps "
      "between surfaces, neighbours per particle and gap. --structure: S(k) = |sum of exp(i k "
      "r)|^2 / N.");
  add_frame_options(*command, options->frames, FrameUse::table);
  add_time_option(*command, options->time_step);
  auto* farthest = command->add_option(
      "--farthest", options->farthest,
      "largest distance of centres (m; default: 4 mean diameters, or what the box allows)");
  farthest->check(CLI::PositiveNumber);
  auto* gap = command->add_option("--gap", options->gap, "gaps up to this one (m)");
  gap->check(CLI::PositiveNumber)->excludes(farthest);
  command
      ->add_option("--lowest-gap", options->lowest_gap,
                   "where the bins begin (m; negative: overlaps)")
      ->needs(gap)
      ->capture_default_str();
  command->add_option("--structure", options->wave_number, "S(k) up to this wave number (1/m)")
      ->check(CLI::PositiveNumber)
      ->excludes(gap)
      ->excludes(farthest);
  command->add_option("--bins", options->bins, "number of bins")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->callback([options, &exit_code] {
    exit_code = run_rows_command(options->frames, "Pairs", FrameOrder::any,
                                 [&](const ChosenFrame& f) { return pair_rows(*options, f); });
  });
}

} // namespace ellipsoid::post
