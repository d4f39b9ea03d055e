// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Lists of contacts with forces beside the particles' dump, read forward as the frames go by.
#pragma once

#include "command.h"
#include "contact_list_options.h"
#include "force_contacts.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

struct ForceListOptions {
  std::vector<std::string> contacts, walls; ///< files and patterns; empty: none
  ForceColumns contact_columns, wall_columns;
  bool is_on_second = false;

  bool is_given() const { return !contacts.empty() || !walls.empty(); }
};

/// Adds --contacts, --wall-contacts and the names of their columns.
void add_force_list_options(CLI::App& command, ForceListOptions& options);

/// Contacts with forces of one frame after the other.
class ForceLists {
 public:
  explicit ForceLists(const ForceListOptions& options);
  /// Throws InputError for a step that is not listed and for forces that pull.
  std::vector<ForceContact> at(std::int64_t timestep, const ParticleSet& set,
                               const PeriodicCell& cell);

 private:
  const ForceListOptions& options_;
  ContactListOptions contact_files_, wall_files_;
  ContactLists contacts_, walls_;
};

} // namespace ellipsoid::post
