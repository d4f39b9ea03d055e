// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "chosen_runs.h"
#include "contact_forces.h"
#include "contact_list_options.h"
#include "contacts.h"
#include "digits_warning.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "frame_stream.h"
#include "measure_rows.h"
#include "messages.h"
#include "option_checks.h"
#include "orientation.h"
#include "table_command.h"

#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

struct ContactsOptions {
  FrameOptions frames;
  bool is_local = false;
  double gap = 0.0;
  int bins = 18;
  std::vector<std::string> normal_columns, force_columns;
  std::string list; ///< path of the table of all contacts; empty: not wanted
};

void append_fabric(Row& row, const std::vector<Vector3>& normals, int bins) {
  const PrincipalAxes fabric = mean_dyad(normals);
  const auto known = [&normals](double value) { // without contacts there is no direction
    return normals.empty() ? Value() : Value(value);
  };
  row.push_back({"contacts", "contacts", "", static_cast<std::int64_t>(normals.size())});
  row.push_back({"fabric_1", "fabric tensor, largest eigenvalue", "", known(fabric.values[0])});
  row.push_back({"fabric_2", "fabric tensor, middle eigenvalue", "", known(fabric.values[1])});
  row.push_back({"fabric_3", "fabric tensor, smallest eigenvalue", "", known(fabric.values[2])});
  row.push_back({"fabric_direction_x", "main direction: x", "", known(fabric.direction.x)});
  row.push_back({"fabric_direction_y", "main direction: y", "", known(fabric.direction.y)});
  row.push_back({"fabric_direction_z", "main direction: z", "", known(fabric.direction.z)});
  append_rose(row, angle_rose(normals, bins));
}

/// @param[in] row run and time step
Row contact_row(Row row, std::int64_t id_1, std::int64_t id_2, const Contact& contact) {
  row.push_back({"id_1", "id 1", "", id_1});
  row.push_back({"id_2", "id 2", "", id_2});
  const auto append = [&row](const std::string& key, const std::string& unit, const Vector3& v) {
    const std::string ending = unit.empty() ? "" : "_" + unit;
    row.push_back({key + "_x" + ending, key + ": x", unit, v.x});
    row.push_back({key + "_y" + ending, key + ": y", unit, v.y});
    row.push_back({key + "_z" + ending, key + ": z", unit, v.z});
  };
  append("point", "m", contact.point);
  append("normal", "", contact.normal);
  row.push_back({"overlap_m", "overlap", "m", contact.overlap});
  return row;
}

/// One row per contact.
std::vector<Row> list_rows(const ChosenFrame& chosen, const ContactNetwork& network) {
  std::vector<Row> rows;
  for (const PairContact& pair : network.pairs)
    for (std::size_t k = pair.first; k < pair.first + pair.count; ++k)
      rows.push_back(contact_row(frame_row(chosen), chosen.set.particles[pair.i].id,
                                 chosen.set.particles[pair.j].id, network.contacts[k]));
  return rows;
}

/// From positions, with the engine's kernel; all contacts are appended to `list`.
Row geometry_row(const ContactsOptions& options, const ChosenFrame& chosen, Table& list) {
  const double gap = options.gap * mean_smallest_axis(chosen.set, all_members(chosen.set));
  warn_of_digits(chosen);
  const ContactNetwork network = find_contacts(chosen.set, gap);
  warn_of_own_images(chosen, network);
  std::vector<Vector3> normals;
  for (const Contact& contact : network.contacts)
    normals.push_back(contact.normal);
  if (!options.list.empty())
    for (Row& row : list_rows(chosen, network))
      list.rows.push_back(std::move(row));
  Row row = frame_row(chosen);
  append_fabric(row, normals, options.bins);
  return row;
}

int run_geometry(const ContactsOptions& options) {
  FrameOptions frames = options.frames;
  if (!options.list.empty())
    frames.threads = 1; // the list grows in the order of the frames
  Table list{"All contacts", {}, contact_row(frame_columns(), 0, 0, {})};
  const int code = run_table_command(
      frames, "Contacts", [&](const ChosenFrame& f) { return geometry_row(options, f, list); });
  if (!options.list.empty() && (code == exit_good || !list.rows.empty()))
    write_text(options.list, as_csv(list));
  return code;
}

/// From a dump local of the engine.
Row local_row(const ContactsOptions& options, const std::string& run, const Frame& frame) {
  Row row = {{"run", "run", "", run}, {"timestep", "time step", "", frame.timestep}};
  if (!options.normal_columns.empty())
    append_fabric(row, vectors_of(frame, options.normal_columns, true), options.bins);
  if (options.force_columns.empty())
    return row;
  const ForceStatistics f = force_statistics(vectors_of(frame, options.force_columns, false));
  row.push_back({"forces", "forces", "", static_cast<std::int64_t>(f.count)});
  row.push_back({"mean_force_N", "mean force", "N", f.mean});
  row.push_back({"largest_force_N", "largest force", "N", f.largest});
  row.push_back({"strong_share", "share of forces above the mean", "", f.strong_share});
  row.push_back({"strong_load_share", "their share of the sum", "", f.strong_load_share});
  for (std::size_t k = 0; k < f.distribution.size(); ++k)
    row.push_back({fmt::format("density_at_{:.2f}", 0.25 * (static_cast<double>(k) + 0.5)),
                   fmt::format("P(f/<f>) at {:.3f}", 0.25 * (static_cast<double>(k) + 0.5)), "",
                   f.distribution[k]});
  return row;
}

/// Reads a run to its end; whether it has a list. The last whole one is kept.
/// @param[in,out] code of the command
bool read_last_list(const Run& run, Frame& last, int& code) {
  FrameStream stream(run.files);
  bool has_last = false;
  Frame frame;
  try {
    while (stream.next(frame)) {
      if (has_last)
        warn_of_order(frame, last.timestep);
      std::swap(frame, last);
      has_last = true;
    }
  } catch (const InputError& error) {
    report_error(error.what());
    code = exit_bad_data;
  }
  return has_last;
}

int run_local(const ContactsOptions& options) {
  if (options.normal_columns.empty() && options.force_columns.empty())
    throw InputError("--local needs --normal-columns, --force-columns or both");
  Table table{"Contacts", {}};
  int code = exit_good;
  for (const Run& run : runs_of(options.frames)) {
    Frame last;
    if (!read_last_list(run, last, code))
      continue;
    if (last.rows == 0)
      report_warning(fmt::format("{}: the last list, of time step {}, holds no contacts", run.name,
                                 last.timestep));
    try {
      table.rows.push_back(local_row(options, run.name, last));
    } catch (const InputError& error) {
      report_error(error.what());
      code = exit_bad_data;
    }
  }
  write_table(options.frames, table);
  return code;
}

} // namespace

void add_contacts_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ContactsOptions>();
  CLI::App* command = program.add_subcommand(
      "contacts", "fabric tensor, rose of contact normals, distribution of forces");
  command->footer(
      "Fabric tensor: <n n> over contact normals n (eigenvalues add up to 1; 1/3 each: isotropic "
      "in space). Without --local the contacts are recomputed from positions with the engine's "
      "kernel. With --local the files are dump local lists, the last frame is used, and columns "
      "are named: --normal-columns NX NY NZ, --force-columns FX FY FZ. Strong forces: above the "
      "mean force <f>; P(f/<f>): probability density in bins 0.25 wide.");
  add_frame_options(*command, options->frames, FrameUse::table);
  CLI::Option* local =
      command->add_flag("--local", options->is_local, "the files are contact lists (dump local)");
  command->add_option("--normal-columns", options->normal_columns, "of a contact list")
      ->expected(3);
  command->add_option("--force-columns", options->force_columns, "of a contact list")->expected(3);
  command->add_option("--contact-gap", options->gap, "particles this close (in b) touch")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option(
      "--list", options->list,
      "write all recomputed contacts as CSV (ids, point, normal, overlap), \"-\": to "
      "standard output");
  command->add_option("--bins", options->bins, "bins of the rose")
      ->check(CLI::Range(1, 360))
      ->capture_default_str();
  for (const char* name :
       {"--frame", "--semiaxes", "--subspheres", "--spacing", "--size-scale", "--column",
        "--bodies", "--periodic", "--threads", "--contact-gap", "--list"})
    local->excludes(command->get_option(name));
  command->callback([command, options, &exit_code] {
    if (!options->is_local)
      refuse_without_effect(*command, {"--normal-columns", "--force-columns"}, "without --local");
    else if (options->normal_columns.empty())
      refuse_without_effect(*command, {"--bins"}, "without --normal-columns");
    if (!options->list.empty())
      refuse_without_effect(*command, {"--threads"}, "with --list");
    exit_code = options->is_local ? run_local(*options) : run_geometry(*options);
  });
}

} // namespace ellipsoid::post
