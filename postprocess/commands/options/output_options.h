// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "command.h"
#include "table.h"

#include <string>

namespace ellipsoid::post {

/// Where a command's table goes.
struct OutputOptions {
  std::string csv, json; ///< paths; empty: not wanted
  bool quiet = false;    ///< no table for people
};

/// Adds --csv and --json.
void add_table_file_options(CLI::App& command, OutputOptions& options);

/// Adds --csv, --json and --quiet.
void add_output_options(CLI::App& command, OutputOptions& options);

/// Whether tables for people go to standard output.
bool prints_text(const OutputOptions& options);

/// Writes a table as the options ask: text on standard output, CSV, JSON. One that has neither rows
/// nor columns is written to no file, with a message.
void write_table(const OutputOptions& options, const Table& table);

} // namespace ellipsoid::post
