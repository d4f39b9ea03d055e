// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "force_list_options.h"

#include "input_error.h"

#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// Of the lists that `list` names: columns of ids, points, forces and normals.
/// @param[in] ids name of the option, @param[in] particles per contact
void add_columns(CLI::App& command, CLI::Option* list, const std::string& prefix,
                 const std::string& of_what, const std::string& ids, int particles,
                 ForceColumns& columns) {
  const auto add = [&](const std::string& name, std::vector<std::string>& values,
                       const std::string& what, int count) {
    return add_list_columns(command, list, "--" + prefix + name, values, of_what + ": " + what,
                            count);
  };
  list->needs(add(ids, columns.ids,
                  particles == 1 ? "id of the particle" : "ids of the two particles", particles));
  add("point-columns", columns.points, "x y z of the contact point", 3);
  list->needs(add("force-columns", columns.forces, "x y z of the force on the particle", 3));
  add("normal-columns", columns.normals, "x y z of the normal, for the fabric", 3);
}

} // namespace

void add_force_list_options(CLI::App& command, ForceListOptions& options) {
  CLI::Option* contacts = command.add_option("--contacts", options.contacts,
                                             "lists (dump local) of contacts between particles");
  add_columns(command, contacts, "", "of the contacts", "id-columns", 2, options.contact_columns);
  command
      .add_flag("--force-on-second", options.is_on_second,
                "the listed forces are those on the second particle")
      ->needs(contacts);
  CLI::Option* walls = command.add_option("--wall-contacts", options.walls,
                                          "lists (dump local) of contacts with walls");
  add_columns(command, walls, "wall-", "of the contacts with walls", "id-column", 1,
              options.wall_columns);
}

ForceLists::ForceLists(const ForceListOptions& options)
    : options_(options), contact_files_{options.contacts, {}}, wall_files_{options.walls, {}},
      contacts_(contact_files_), walls_(wall_files_) {}

std::vector<ForceContact> ForceLists::at(std::int64_t timestep, const ParticleSet& set,
                                         const PeriodicCell& cell) {
  std::vector<ForceContact> all;
  if (!options_.contacts.empty()) {
    const Frame& list = contacts_.at(timestep);
    all = force_contacts(list, options_.contact_columns, set);
    if (options_.is_on_second)
      for (ForceContact& contact : all)
        contact.force = -contact.force;
    if (forces_pull(all, set, cell))
      throw InputError(fmt::format("{}: time step {}: the forces pull the particles together: {}",
                                   list.location.file, timestep,
                                   options_.is_on_second
                                       ? "leave out --force-on-second"
                                       : "if they act on the second particle of each row, give "
                                         "--force-on-second"));
  }
  if (options_.walls.empty())
    return all;
  const Frame& list = walls_.at(timestep);
  const std::vector<ForceContact> walls = force_contacts(list, options_.wall_columns, set);
  if (forces_pull(walls, set, cell))
    throw InputError(fmt::format("{}: time step {}: the forces pull the particles to the walls: "
                                 "expected the force on the particle",
                                 list.location.file, timestep));
  all.insert(all.end(), walls.begin(), walls.end());
  return all;
}

} // namespace ellipsoid::post
