// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "command.h"
#include "contact_forces.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ellipsoid::post {

class FrameStream;

/// Contact lists (dump local) that belong to the particles' dump.
struct ContactListOptions {
  std::vector<std::string> files; ///< and patterns; empty: none
  ContactColumns columns;
};

/// Adds an option with the names of `count` columns of the lists that `list` names.
CLI::Option* add_list_columns(CLI::App& command, CLI::Option* list, const std::string& name,
                              std::vector<std::string>& columns, const std::string& what,
                              int count);

/// Adds --contacts (with the command's own `purpose`) and --id-columns.
/// @return --contacts, for options that need it
CLI::Option* add_contact_list_options(CLI::App& command, ContactListOptions& options,
                                      const std::string& purpose);

/// The same with --force-columns, which --contacts then needs, and --normal-columns.
/// @param[in] purpose of the list, @param[in] shown what becomes of the force: "drawn"
void add_force_list_options(CLI::App& command, ContactListOptions& options,
                            const std::string& purpose, const std::string& shown);

/// Says once that a list comes again, or not in the order of time.
void warn_of_order(const Frame& list, std::int64_t before);

/// The contact lists of a series, read forwards once: to be asked in the order of time.
class ContactLists {
 public:
  explicit ContactLists(const ContactListOptions& options);
  ~ContactLists();

  /// The list at one time step. Throws InputError when there is none.
  const Frame& at(std::int64_t timestep);

 private:
  void begin();

  const ContactListOptions& options_;
  std::unique_ptr<FrameStream> stream_;
  Frame list_;
  bool has_list_ = false;
};

} // namespace ellipsoid::post
