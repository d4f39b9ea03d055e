// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contact_list_options.h"

#include "frame_stream.h"
#include "messages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ellipsoid::post {

CLI::Option* add_list_columns(CLI::App& command, CLI::Option* list, const std::string& name,
                              std::vector<std::string>& columns, const std::string& what,
                              int count) {
  return command.add_option(name, columns, what)->expected(count)->needs(list);
}

CLI::Option* add_contact_list_options(CLI::App& command, ContactListOptions& options,
                                      const std::string& purpose) {
  CLI::Option* contacts = command.add_option(
      "--contacts", options.files, "contact lists (dump local) of the same time steps: " + purpose);
  contacts->needs(add_list_columns(command, contacts, "--id-columns", options.columns.ids,
                                   "of the contact list: ids of the two particles", 2));
  return contacts;
}

void add_force_list_options(CLI::App& command, ContactListOptions& options,
                            const std::string& purpose, const std::string& shown) {
  auto* contacts = add_contact_list_options(command, options, purpose);
  contacts->needs(add_list_columns(command, contacts, "--force-columns", options.columns.forces,
                                   "of the contact list: the force", 3));
  add_list_columns(
      command, contacts, "--normal-columns", options.columns.normals,
      "of the contact list: the normal; then only the normal part of the force is " + shown, 3);
}

void warn_of_order(const Frame& list, std::int64_t before) {
  if (list.timestep <= before)
    report_warning(fmt::format("{}: frame {} is of time step {}, after one of {}: lists are "
                               "repeated or not in the order of time",
                               list.location.file, list.location.frame, list.timestep, before),
                   "order of lists");
}

ContactLists::ContactLists(const ContactListOptions& options) : options_(options) {}
ContactLists::~ContactLists() = default;

void ContactLists::begin() {
  const std::vector<Run> runs = runs_of(options_.files, RunGrouping::one_run);
  stream_ = std::make_unique<FrameStream>(runs.front().files);
  has_list_ = false;
}

const Frame& ContactLists::at(std::int64_t timestep) {
  if (!stream_ || (has_list_ && list_.timestep > timestep))
    begin(); // another run, or frames that are not in the order of time
  while (!(has_list_ && list_.timestep >= timestep)) {
    const bool has_before = has_list_;
    const std::int64_t before = list_.timestep;
    has_list_ = stream_->next(list_);
    if (!has_list_)
      break;
    if (has_before)
      warn_of_order(list_, before);
  }
  if (has_list_ && list_.timestep == timestep)
    return list_;
  if (!has_list_)
    stream_.reset();
  throw InputError(fmt::format("{}: no contacts of time step {}; dump both at the same steps",
                               fmt::join(options_.files, " "), timestep));
}

} // namespace ellipsoid::post
