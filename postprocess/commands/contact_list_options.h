// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "command.h"
#include "contact_forces.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// Contact lists (dump local) that belong to the particles' dump.
struct ContactListOptions {
  std::vector<std::string> files; ///< and patterns; empty: none
  ContactColumns columns;
};

/// Adds --contacts (with the command's own `purpose`) and --id-columns.
/// @return --contacts, for options that need it
CLI::Option* add_contact_list_options(CLI::App& command, ContactListOptions& options,
                                      const std::string& purpose);

/// The same with --force-columns, which --contacts then needs, and --normal-columns.
/// @param[in] purpose of the list, @param[in] shown what becomes of the force: "drawn"
void add_force_list_options(CLI::App& command, ContactListOptions& options,
                            const std::string& purpose, const std::string& shown);

/// The list at one time step. Throws InputError when there is none.
Frame contact_list_at(const ContactListOptions& options, std::int64_t timestep);

} // namespace ellipsoid::post
