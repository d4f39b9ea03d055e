// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contact_list_options.h"
#include "digits_warning.h"
#include "frame_loop.h"
#include "measure_rows.h"
#include "pile_definitions.h"
#include "pile_measures.h"
#include "pile_options.h"
#include "plane_options.h"
#include "table_command.h"

#include <memory>
#include <utility>

namespace ellipsoid::post {
namespace {

struct CoordinationCommandOptions : PileCommandOptions {
  ContactListOptions contacts;
};

Row coordination_row(const CoordinationCommandOptions& options, ContactLists& lists,
                     const ChosenFrame& chosen) {
  const PileOptions settings = plane_settings(options.plane);
  const bool is_listed = !options.contacts.files.empty();
  NearPairs near = near_pairs(chosen.set, settings);
  ContactNetwork network;
  if (!is_listed)
    network = early_contacts(options, chosen.set, near);
  const PileBody pile = find_pile_body(chosen.set, settings, std::move(near), network.pairs);
  const CoordinationOptions counting = coordination_settings(options, settings, pile.mean_b);
  if (!is_listed)
    warn_of_digits(chosen);
  if (is_listed)
    network =
        listed_contacts(lists.at(chosen.frame.timestep), options.contacts.columns, chosen.set);
  else if (counting.gap > 0.0)
    network = find_contacts(chosen.set, counting.gap, pile.near);
  warn_of_own_images(chosen, network);
  const Coordination z = coordination(chosen.set, pile.members, network, counting);
  Row row = frame_row(chosen);
  append_pile(row, chosen.set, pile, settings);
  append_coordination(row, z, pile.mean_b);
  append_distribution(row, z);
  return row;
}

} // namespace

void add_coordination_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<CoordinationCommandOptions>();
  CLI::App* command = program.add_subcommand("coordination", "coordination numbers and overlaps");
  command->footer(
      std::string(pile_definition) + "\n" + coordination_definition +
      "\nWith --contacts the contacts of the particles are those of the list (walls are "
      "looked up in the geometry); overlaps are known with --overlap-column only.");
  add_frame_options(*command, options->frames);
  add_plane_options(*command, options->plane);
  add_coordination_options(*command, *options);
  auto* contacts = add_contact_list_options(*command, options->contacts,
                                            "counts these instead of recomputing them");
  command
      ->add_option("--overlap-column", options->contacts.columns.overlap,
                   "of the contact list: the overlap")
      ->needs(contacts);
  command->callback([options, &exit_code] {
    ContactLists lists(options->contacts);
    if (!options->contacts.files.empty())
      options->frames.threads = 1; // the lists are read in the order of the frames
    exit_code =
        run_table_command(options->frames, "Coordination numbers", [&](const ChosenFrame& f) {
          return coordination_row(*options, lists, f);
        });
  });
}

} // namespace ellipsoid::post
