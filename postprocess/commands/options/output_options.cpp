// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "output_options.h"

#include "long_tables.h"
#include "messages.h"

#include <fmt/format.h>
#include <utility>

namespace ellipsoid::post {

void add_table_file_options(CLI::App& command, OutputOptions& options) {
  command.add_option("--csv", options.csv,
                     "write the table as CSV to a file, \"-\": to standard output");
  command.add_option("--json", options.json,
                     "write the table as JSON to a file, \"-\": to standard output");
}

void add_output_options(CLI::App& command, OutputOptions& options) {
  add_table_file_options(command, options);
  command.add_flag("--quiet", options.quiet, "print no table for people");
}

bool prints_text(const OutputOptions& options) {
  return !options.quiet && options.csv != "-" && options.json != "-";
}

void write_table(const OutputOptions& options, const Table& table) {
  refuse_one_name(options);
  if (table.header().empty()) {
    for (const auto& [option, path] : {std::pair("--csv", options.csv), {"--json", options.json}})
      if (!path.empty())
        report_error(fmt::format("{} {}: not written, there is no row", option, path));
    return;
  }
  if (prints_text(options) && !table.rows.empty())
    write_text("-", as_text(table));
  if (!options.csv.empty())
    write_text(options.csv, as_csv(table));
  if (!options.json.empty())
    write_text(options.json, as_json(table));
}

} // namespace ellipsoid::post
