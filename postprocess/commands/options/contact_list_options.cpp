// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contact_list_options.h"

#include "frame_stream.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ellipsoid::post {

CLI::Option* add_contact_list_options(CLI::App& command, ContactListOptions& options,
                                      const std::string& purpose) {
  CLI::Option* contacts = command.add_option(
      "--contacts", options.files, "contact lists (dump local) of the same time steps: " + purpose);
  CLI::Option* ids = command.add_option("--id-columns", options.columns.ids,
                                        "of the contact list: ids of the two particles");
  ids->expected(2)->needs(contacts);
  contacts->needs(ids);
  return contacts;
}

void add_force_list_options(CLI::App& command, ContactListOptions& options,
                            const std::string& purpose, const std::string& shown) {
  auto* contacts = add_contact_list_options(command, options, purpose);
  auto* forces = command.add_option("--force-columns", options.columns.forces,
                                    "of the contact list: the force");
  auto* normals = command.add_option("--normal-columns", options.columns.normals,
                                     "of the contact list: the normal; then only the normal part "
                                     "of the force is " +
                                         shown);
  forces->expected(3)->needs(contacts);
  normals->expected(3)->needs(contacts);
  contacts->needs(forces);
}

ContactLists::ContactLists(const ContactListOptions& options) : m_options(options) {}
ContactLists::~ContactLists() = default;

void ContactLists::begin() {
  const std::vector<Run> runs = runs_of(m_options.files, RunGrouping::one_run);
  m_stream = std::make_unique<FrameStream>(runs.front().files);
  m_has_list = false;
}

const Frame& ContactLists::at(std::int64_t timestep) {
  if (!m_stream || (m_has_list && m_list.timestep > timestep))
    begin(); // another run, or frames that are not in the order of time
  while (!(m_has_list && m_list.timestep >= timestep)) {
    m_has_list = m_stream->next(m_list);
    if (!m_has_list)
      break;
  }
  if (m_has_list && m_list.timestep == timestep)
    return m_list;
  if (!m_has_list)
    m_stream.reset();
  throw InputError(fmt::format("{}: no contacts of time step {}; dump both at the same steps",
                               fmt::join(m_options.files, " "), timestep));
}

} // namespace ellipsoid::post
