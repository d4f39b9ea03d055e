// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pile_analysis.h"

#include "pile_commands.h"

#include <fmt/format.h>
#include <utility>

namespace ellipsoid::post {

const char* const pile_definition =
    "Pile: all particles connected with the wall through particles whose semi-axes, enlarged by "
    "half of --cluster-gap each, touch; the largest such cluster if several touch the wall. "
    "Particles that rolled away do not belong to it (they are counted as strays).\n"
    "Free surface: y_max(x), the largest ordinate of the true outlines (ellipses, or sub-sphere "
    "discs) at x, computed exactly as a chain of arcs; the floor where there is no particle.";

const char* const repose_definition =
    "Angle of repose (paper, section 4.2.1): atan(-slope) of the least squares line "
    "y = p + slope x through y_max(x), in columns 0.05 b apart (--columns), from A to B. "
    "h(x) is the mean of y_max over x +- a (one particle length), H its largest value, at x_H. A "
    "is "
    "the first column from x_H downhill with h < (1 - cut_top) H, B the last one before h first "
    "falls below cut_bottom H: particles that rolled off and lie beyond do not count. Both cuts "
    "are "
    "0.2 by default: about four particle lengths at top and bottom of the paper's pile of 1000; "
    "60 % of the slope remain.\n"
    "Standard error: s / sqrt(S_xx) sqrt(n / m) / (1 + slope^2), s^2 = sum of squared residuals / "
    "(n - 2), n columns, m = length of A-B over 2a: columns on one particle are not independent.\n"
    "Without a wall (--no-wall) both flanks are fitted; the angle is the mean of both, its "
    "standard "
    "error sqrt(left^2 + right^2) / 2.";

const char* const porosity_definition =
    "Porosity (paper, section 4.2.2): 1 - solid / total. total: area between floor, wall and "
    "y_max(x), in closed form arc by arc. solid: area of the union of the section outlines, "
    "each point counted once (overlaps, lenses of about 1e-5 of the area, are subtracted), exact "
    "by Green's theorem. 'by sum' adds the areas pi a b (2) or of the cut-off spheres (9) one by "
    "one as the paper does. --outline ellipse gives 'MS ellipse' of the paper.\n"
    "Regions: whole (the pile's whole extent), middle (between the abscissas of A and B, without a "
    "wall between both B), core (at "
    "least --margin away from wall, floor and the line A-B, without the free surface itself).";

const char* const coordination_definition =
    "Coordination numbers (paper, section 4.2.3): Zpp = 2 Ncp / K with Ncp touching pairs among "
    "the K particles of the pile, Zss = 2 Ncs / K with Ncs touching pairs of sub-spheres of "
    "different particles. Touching: overlap h >= 0 of the engine's own contact kernel (or "
    "h >= -gap with --contact-gap). --with-walls adds 1 for each wall that a particle touches. "
    "Rattlers: particles with fewer than 2 contacts, walls included.";

void add_porosity_options(CLI::App& command, PileCommandOptions& options) {
  command.add_option("--region", options.region, "whole, middle or core")
      ->check(CLI::IsMember({"whole", "middle", "core"}))
      ->capture_default_str();
  command.add_option("--margin", options.margin, "of the core, in mean largest semi-axes a")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void add_coordination_options(CLI::App& command, PileCommandOptions& options) {
  command.add_flag("--with-walls", options.with_walls, "count contacts with wall and floor");
  command
      .add_option("--contact-gap", options.contact_gap,
                  "particles this close (in b) count as touching")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

void add_rest_options(CLI::App& command, PileCommandOptions& options) {
  command
      .add_option("--gravity", options.gravity,
                  "for the rest check: every point slower than 0.01 sqrt(g b)")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

PorosityOptions porosity_settings(const PileCommandOptions& options) {
  PorosityOptions result;
  result.margin = options.margin;
  if (options.region == "middle")
    result.region = PorosityRegion::middle;
  else if (options.region == "core")
    result.region = PorosityRegion::core;
  return result;
}

CoordinationOptions coordination_settings(const PileCommandOptions& options,
                                          const PileOptions& pile, double mean_b) {
  CoordinationOptions result;
  result.count_walls = options.with_walls;
  result.walls = walls_of(pile);
  result.gap = options.contact_gap * mean_b;
  return result;
}

Pile plane_pile(const ChosenFrame& chosen, const PileOptions& options) {
  return plane_pile(chosen, options, near_pairs(chosen.set, options), {});
}

ContactNetwork early_contacts(const PileCommandOptions& options, const ParticleSet& set,
                              const NearPairs& near) {
  return options.contact_gap > 0.0 ? ContactNetwork() : find_contacts(set, 0.0, near);
}

Pile plane_pile(const ChosenFrame& chosen, const PileOptions& options, NearPairs near,
                const std::vector<PairContact>& touching) {
  constexpr double noticeable = 0.01; // of b
  Pile pile = find_pile(chosen.set, options, std::move(near), touching);
  if (!options.section && pile.out_of_plane > noticeable * pile.mean_b)
    report_warning(
        fmt::format("{}: centres lie up to {:.2g} b out of the plane z = {:.4g}: what is "
                    "measured is the section there (--section); `heap` and `bed` measure "
                    "particles in space",
                    chosen.run, pile.out_of_plane / pile.mean_b, pile.section));
  return pile;
}

PileResult analyse_pile(const PileCommandOptions& options, const ChosenFrame& chosen) {
  const PileOptions settings = plane_settings(options.plane);
  NearPairs near = near_pairs(chosen.set, settings);
  ContactNetwork network = early_contacts(options, chosen.set, near);
  PileResult result{settings,
                    plane_pile(chosen, settings, std::move(near), network.pairs),
                    {},
                    frame_row(chosen)};
  const Pile& pile = result.pile;
  warn_of_digits(chosen);
  append_pile(result.row, chosen.set, pile, settings);
  std::string why;
  result.flanks = try_flanks(pile, settings, &why);
  append_flanks(result.row, result.flanks);
  if (result.flanks.empty())
    report_warning(chosen.run + ": no angle of repose: " + why);
  append_porosity(result.row,
                  plane_porosity(pile, settings, porosity_settings(options), result.flanks));
  const CoordinationOptions contacts = coordination_settings(options, settings, pile.mean_b);
  if (contacts.gap > 0.0)
    network = find_contacts(chosen.set, contacts.gap, pile.near);
  append_coordination(result.row, coordination(chosen.set, pile.members, network, contacts),
                      pile.mean_b);
  append_rest(result.row, check_rest(chosen.set, pile.members, options.gravity));
  return result;
}

std::vector<ReposeAngle> fitted_flanks(const Pile& pile, const PileOptions& options) {
  std::vector<ReposeAngle> flanks;
  if (!options.wall)
    flanks.push_back(repose_angle(pile, options, Flank::left));
  flanks.push_back(repose_angle(pile, options, Flank::right));
  return flanks;
}

std::vector<ReposeAngle> try_flanks(const Pile& pile, const PileOptions& options,
                                    std::string* why) {
  try {
    return fitted_flanks(pile, options);
  } catch (const InputError& error) {
    if (why)
      *why = error.what();
    return {};
  }
}

} // namespace ellipsoid::post
