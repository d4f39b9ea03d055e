// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "bed.h"
#include "frame_options.h"
#include "gravity_options.h"
#include "option_checks.h"
#include "rows_command.h"

#include <memory>

namespace ellipsoid::post {
namespace {

struct BedOptions {
  FrameOptions frames;
  std::string up, profile;
  std::vector<double> box, cylinder;
  int planes = 200, slices = 10;
  bool is_below_surface = false;
  double column_width = 0.25; ///< of the free surface, in b
};

/// The free surface, if the region ends there.
BedSurface surface_of(const BedOptions& options, const ParticleSet& set, const BedRegion& region) {
  if (!options.is_below_surface)
    return {};
  const auto members = all_members(set);
  return HeightMap(set, members, options.column_width * mean_smallest_axis(set, members),
                   region.z0);
}

BedRegion region_of(const BedOptions& options) {
  BedRegion region;
  if (!options.box.empty()) {
    const auto& b = options.box;
    region = {BedShape::box, b[0], b[1], b[2], b[3], 0.0, 0.0, 0.0, b[4], b[5]};
  } else if (!options.cylinder.empty()) {
    const auto& c = options.cylinder;
    region = {BedShape::cylinder, 0.0, 0.0, 0.0, 0.0, c[0], c[1], c[2], c[3], c[4]};
  } else {
    throw InputError("give the region: --box x0 x1 y0 y1 z0 z1 or --cylinder x y radius z0 z1");
  }
  return region;
}

/// A frame as its measures take it.
struct BedFrame {
  UpDirection up;
  BedRegion region;
  ParticleSet set; ///< upright, with images
  BedSurface surface;
};

BedFrame bed_frame(const BedOptions& options, const ChosenFrame& chosen) {
  BedFrame bed;
  bed.up = up_direction(options.up, chosen);
  bed.region = region_of(options);
  bed.set = particles_in(turned_upright(chosen.set, bed.up.axis), bed.region);
  bed.surface = surface_of(options, bed.set, bed.region);
  return bed;
}

Row bed_row(const BedOptions& options, const ChosenFrame& chosen) {
  const BedFrame bed = bed_frame(options, chosen);
  const BedPorosity p = bed_porosity(bed.set, bed.region, options.planes, bed.surface);
  if (!(p.total_volume > 0.0))
    throw InputError("the region has no volume below the free surface: check its bounds and --up");
  Row row = frame_row(chosen);
  append_up(row, bed.up);
  row.push_back({"porosity", "porosity", "", p.porosity});
  row.push_back({"porosity_error", "error of the integration", "", p.error});
  row.push_back({"total_volume_m3", "volume of the region", "m3", p.total_volume});
  row.push_back({"solid_volume_m3", "volume of the particles in it", "m3", p.solid_volume});
  return row;
}

std::vector<Row> profile_rows(const BedOptions& options, const ChosenFrame& chosen) {
  const BedFrame bed = bed_frame(options, chosen);
  const bool is_radial = options.profile == "radius";
  if (is_radial && bed.region.shape != BedShape::cylinder)
    throw InputError("a radial profile needs --cylinder");
  std::vector<Row> rows;
  const auto profile = is_radial ? radial_profile : height_profile;
  for (const BedSlice& slice :
       profile(bed.set, bed.region, options.slices, options.planes, bed.surface)) {
    Row& row = rows.emplace_back(frame_row(chosen));
    append_up(row, bed.up);
    row.push_back({"begin_m", is_radial ? "from radius" : "from height", "m", slice.begin});
    row.push_back({"end_m", is_radial ? "to radius" : "to height", "m", slice.end});
    row.push_back({"porosity", "porosity", "", slice.porosity});
  }
  return rows;
}

std::vector<Row> rows_of(const BedOptions& options, const ChosenFrame& chosen) {
  return options.profile.empty() ? std::vector<Row>{bed_row(options, chosen)}
                                 : profile_rows(options, chosen);
}

void add_region_options(CLI::App& command, BedOptions& options) {
  auto* box = command.add_option("--box", options.box, "x0 x1 y0 y1 z0 z1")->expected(6);
  command.add_option("--cylinder", options.cylinder, "x y radius z0 z1")
      ->expected(5)
      ->excludes(box);
  command.add_option("--profile", options.profile, "height or radius")
      ->check(CLI::IsMember({"height", "radius"}));
  command.add_option("--slices", options.slices, "layers or rings of the profile")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command.add_flag("--below-surface", options.is_below_surface,
                   "the region ends at the free surface of the bed");
  command.add_option("--columns", options.column_width, "width of the surface's columns, in b")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  command.add_option("--planes", options.planes, "planes of the integration")
      ->check(CLI::Range(8, 100000))
      ->capture_default_str();
}

} // namespace

void add_bed_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<BedOptions>();
  CLI::App* command =
      program.add_subcommand("bed", "porosity of a 3D bed in a box or cylinder, and its profile");
  command->footer(
      "Porosity: 1 - V_solid / V. V_solid: exact area of the union of all sections with the region "
      "in planes of constant height, each point counted once, summed over --planes planes in the "
      "middles of equal layers. The stated error is the difference to the same sum over half of "
      "the planes (the true one is smaller, it falls with the square of the planes' distance). "
      "Profiles: --profile height (layers) or radius (rings of a cylinder).\n"
      "--below-surface: the region ends at the free surface z_max(x, y) of the true outlines, "
      "taken at the middles of square columns 0.25 b wide (--columns) as for `heap`; V is then the "
      "volume between z0 and the lower one of surface and z1.");
  add_frame_options(*command, options->frames, FrameUse::table);
  add_up_option(*command, options->up);
  add_region_options(*command, *options);
  command->callback([command, options, &exit_code] {
    if (options->profile.empty())
      refuse_without_effect(*command, {"--slices"}, "without --profile");
    if (!options->is_below_surface)
      refuse_without_effect(*command, {"--columns"}, "without --below-surface");
    exit_code = run_rows_command(options->frames, "Porosity of a bed", FrameOrder::any,
                                 [&](const ChosenFrame& f) { return rows_of(*options, f); });
  });
}

} // namespace ellipsoid::post
