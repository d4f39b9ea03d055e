// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contact_list_options.h"
#include "digits_warning.h"
#include "frame_loop.h"
#include "measure_rows.h"
#include "option_checks.h"
#include "particle_values.h"
#include "pile_definitions.h"
#include "pile_measures.h"
#include "pile_options.h"
#include "plane_options.h"
#include "run_state.h"
#include "space_wall_options.h"
#include "table_command.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <utility>

namespace ellipsoid::post {
namespace {

struct CoordinationCommandOptions : PileCommandOptions {
  ContactListOptions contacts;
  SpaceWallOptions space_walls;
  bool is_space = false, has_run_walls = false;
  std::string per_particle, log;
  std::string of_piles; ///< an option that was given and has no effect in space
};

/// Walls that the options give, and those of the run.
std::vector<SpaceWall> walls_in_space(const CoordinationCommandOptions& options,
                                      const ChosenFrame& chosen) {
  std::vector<SpaceWall> walls = space_walls(options.space_walls);
  if (!options.has_run_walls)
    return walls;
  const std::string log =
      options.log.empty() ? log_file_beside(chosen.frame.location.file) : options.log;
  if (log.empty())
    throw InputError("--run-walls: there is no log (log.*, *.log) beside the dump: give --log");
  for (SpaceWall& wall : walls_of_log(log))
    walls.push_back(std::move(wall));
  return walls;
}

/// Whether all centres lie at the same z, as those of an in-plane pile do.
bool lie_in_plane(const ParticleSet& set) {
  constexpr double off_the_plane = 1.0e-6; // of the smallest semi-axis: six digits of a file
  return std::all_of(set.particles.begin(), set.particles.end(), [&](const Particle& p) {
    return std::abs(p.centre.z - set.particles.front().centre.z) <=
           off_the_plane * p.smallest_axis() + 1.0e-12 * std::abs(p.centre.z);
  });
}

/// Mean numbers of partners of one type about a particle of another.
void append_kinds(Row& row, const ParticleSet& set, const ContactNetwork& network) {
  set.has_types.require_readable();
  std::map<std::int64_t, double> count;
  std::map<std::pair<std::int64_t, std::int64_t>, double> partners;
  for (const Particle& p : set.particles)
    count[p.type] += 1.0;
  if (count.size() < 2)
    return;
  for (const PairContact& pair : network.pairs) {
    const std::int64_t first = set.particles[pair.i].type, second = set.particles[pair.j].type;
    partners[{first, second}] += 1.0;
    partners[{second, first}] += 1.0;
  }
  for (const auto& of : count)
    for (const auto& with : count)
      row.push_back({fmt::format("z_type_{}_with_{}", of.first, with.first),
                     fmt::format("partners of type {} about one of type {}", with.first, of.first),
                     "", partners[{of.first, with.first}] / of.second});
}

void write_partners(const std::string& path, const ChosenFrame& chosen,
                    const ContactNetwork& network, const CoordinationOptions& counting) {
  const Partners partners = count_partners(chosen.set, network.pairs, counting);
  std::vector<ParticleValues> columns{{"partners", {}}, {"walls_touched", {}}, {"is_rattler", {}}};
  for (std::size_t i = 0; i < chosen.set.particles.size(); ++i) {
    columns[0].values.push_back(static_cast<double>(partners.particles[i]));
    columns[1].values.push_back(static_cast<double>(partners.walls[i]));
    columns[2].values.push_back(
        partners.particles[i] + partners.walls[i] < counting.rattler_contacts ? 1.0 : 0.0);
  }
  write_particle_values(path, chosen, columns);
}

/// Throws InputError for options that count contacts with walls where there are none.
void require_effect(const CoordinationCommandOptions& options,
                    const CoordinationOptions& counting) {
  if (!counting.walls.empty())
    return;
  if (options.with_walls)
    throw InputError("--with-walls has no effect without walls: give --plane-wall, "
                     "--cylinder-wall, --box-wall, --mesh-wall or --run-walls");
  if (options.contact_gap > 0.0 && !options.contacts.files.empty())
    throw InputError("--contact-gap has no effect with --contacts and without walls: leave it out");
}

/// All particles of a packing in space, with the walls of the options and of the run.
Row space_row(const CoordinationCommandOptions& options, ContactLists& lists,
              const ChosenFrame& chosen) {
  const double mean_b = mean_smallest_axis(chosen.set, all_members(chosen.set));
  CoordinationOptions counting;
  counting.count_walls = options.with_walls;
  counting.walls = walls_in_space(options, chosen);
  counting.gap = options.contact_gap * mean_b;
  require_effect(options, counting);
  counting.rattler_contacts = 4; // in space fewer cannot hold a sphere
  ContactNetwork network;
  if (options.contacts.files.empty()) {
    warn_of_digits(chosen);
    network = find_contacts(chosen.set, counting.gap);
    warn_of_own_images(chosen, network);
  } else {
    network =
        listed_contacts(lists.at(chosen.frame.timestep), options.contacts.columns, chosen.set);
  }
  const Coordination z = coordination(chosen.set, all_members(chosen.set), network, counting);
  if (!options.per_particle.empty())
    write_partners(options.per_particle, chosen, network, counting);
  Row row = frame_row(chosen);
  append_surface(row, chosen.set);
  row.push_back({"particles", "particles", "", static_cast<std::int64_t>(z.particles)});
  append_coordination(row, z, mean_b);
  append_kinds(row, chosen.set, network);
  append_distribution(row, z);
  return row;
}

Row coordination_row(const CoordinationCommandOptions& options, ContactLists& lists,
                     const ChosenFrame& chosen) {
  if (chosen.set.particles.empty())
    throw InputError("there are no particles");
  if (options.is_space || !lie_in_plane(chosen.set)) {
    if (!options.of_piles.empty())
      throw InputError(options.of_piles + " is of piles in the plane; this is a packing in space: "
                                          "leave it out");
    return space_row(options, lists, chosen);
  }
  if (!options.per_particle.empty() || options.has_run_walls ||
      !space_walls(options.space_walls).empty())
    throw InputError("all centres lie in one plane: give --space for walls in space and values "
                     "per particle");
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

/// Of packings in space.
void add_wall_options(CLI::App& command, CoordinationCommandOptions& options) {
  add_space_wall_options(command, options.space_walls);
  auto* run_walls =
      command.add_flag("--run-walls", options.has_run_walls,
                       "walls of the run's log: planes, cylinders, and STL meshes that rest");
  command.add_option("--log", options.log, "the run's log (default: that beside the dump)")
      ->check(CLI::ExistingFile)
      ->needs(run_walls);
}

} // namespace

void add_coordination_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<CoordinationCommandOptions>();
  CLI::App* command = program.add_subcommand("coordination", "coordination numbers and overlaps");
  command->footer(
      std::string(pile_definition) + "\n" + coordination_definition +
      "\n"
      "Particles whose centres do not all lie in one plane are a packing in space: all of them "
      "count, contacts across periodic boundaries too, walls are those that are told, and rattlers "
      "have fewer than 4 contacts.\n"
      "With --contacts the contacts of the particles are those of the list (walls are looked up in "
      "the geometry); overlaps are known with --overlap-column only.");
  add_frame_options(*command, options->frames, FrameUse::table);
  add_plane_options(*command, options->plane);
  add_coordination_options(*command, *options);
  auto* contacts = add_contact_list_options(*command, options->contacts,
                                            "counts these instead of recomputing them");
  command
      ->add_option("--overlap-column", options->contacts.columns.overlap,
                   "of the contact list: the overlap")
      ->needs(contacts);
  add_wall_options(*command, *options);
  command->add_flag("--space", options->is_space,
                    "a packing in space, also where all centres lie in one plane");
  add_particle_values_option(*command, options->per_particle);
  command->callback([command, options, &exit_code] {
    for (const std::string& name : plane_options)
      if (command->get_option(name)->count() > 0)
        options->of_piles = name;
    ContactLists lists(options->contacts);
    if (!options->contacts.files.empty()) {
      refuse_without_effect(*command, {"--threads"}, "with --contacts");
      options->frames.threads = 1; // the lists are read in the order of the frames
    }
    exit_code =
        run_table_command(options->frames, "Coordination numbers", [&](const ChosenFrame& f) {
          return coordination_row(*options, lists, f);
        });
  });
}

} // namespace ellipsoid::post
