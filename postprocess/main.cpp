// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "command.h"
#include "frame_options.h"

#include <exception>

int main(int argc, char** argv) {
  using namespace ellipsoid::post;
  CLI::App program("ellipsoid-post: measures and shows what LIGGGHTS piled up, from its dumps.",
                   "ellipsoid-post");
  program.require_subcommand(1);
  program.footer("ellipsoid-post COMMAND --help explains a command and its definitions.\n"
                 "Exit codes: 0 good, 1 broken or missing data, 2 wrong usage.");
  int exit_code = exit_good;
  for (unsigned k = 0; k < command_count; ++k)
    command_rows[k].add(program, exit_code);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? exit_good : exit_bad_usage;
  } catch (const std::exception& error) {
    report_error(error.what());
    return exit_bad_data;
  }
  return exit_code;
}
