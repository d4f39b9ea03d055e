// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pile_measures.h"

#include "digits_warning.h"
#include "gravity_options.h"
#include "measure_rows.h"
#include "messages.h"
#include "plane_options.h"
#include "run_state.h"

#include <fmt/format.h>
#include <utility>

namespace ellipsoid::post {

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

PileResult measure_pile(const PileCommandOptions& options, const ChosenFrame& chosen) {
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
  const Gravity gravity = gravity_of(options.gravity, chosen);
  append_rest(result.row, check_rest(chosen.set, pile.members, gravity.magnitude));
  append_gravity(result.row, gravity);
  append_completeness(result.row, chosen);
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
