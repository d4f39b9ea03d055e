// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A command of ellipsoid-post: one file with one function that adds it, and one row in
// registry.cpp.
#pragma once

#include <CLI/CLI.hpp>

namespace ellipsoid::post {

/// Exit codes of ellipsoid-post, for scripts.
enum ExitCode : int {
  exit_good = 0,      ///< all went well
  exit_bad_data = 1,  ///< an input is broken or missing; what could be measured is printed
  exit_bad_usage = 2, ///< unknown option, bad value
};

/// Adds a subcommand to the program; what it does is run by CLI11's callback, its exit code goes
/// to `exit_code`. What the callback throws is reported by main(), with exit_bad_data.
using AddCommand = void (*)(CLI::App& program, int& exit_code);

struct CommandRow {
  const char* name;
  AddCommand add;
};

/// All commands in the order of the help.
extern const CommandRow command_rows[];
extern const unsigned command_count;

} // namespace ellipsoid::post
