// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "command.h"
#include "command_line.h"
#include "messages.h"
#include "version_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

/// Every frame needs as much memory as the one before: what is free is not given back in between.
void keep_free_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 8 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

/// Makes "-0.5" of "-.5", which would be taken for an option.
void complete_number(std::string& word) {
  if (word.size() > 2 && word[0] == '-' && word[1] == '.' && word[2] >= '0' && word[2] <= '9')
    word.insert(1, "0");
}

std::string not_finite(const std::string& word) {
  const char* const begin = word.c_str();
  char* end = nullptr;
  const double number = std::strtod(begin, &end);
  return end != begin && !std::isfinite(number) ? "expected a finite number, found " + word : "";
}

/// "nan" and "inf" are no numbers for any option, also where every number is allowed.
void require_finite_numbers(CLI::App& app) {
  for (CLI::Option* option : app.get_options([](CLI::Option*) { return true; }))
    if (option->get_type_name().find("FLOAT") != std::string::npos)
      option->check(not_finite);
  for (CLI::App* part : app.get_subcommands([](CLI::App*) { return true; }))
    require_finite_numbers(*part); // commands, and groups of their options
}

/// One line, as all other errors are.
std::string one_line(const CLI::App*, const CLI::Error& error) {
  std::string text = error.what();
  for (std::size_t k = text.find('\n'); k != std::string::npos; k = text.find('\n'))
    text.replace(k, 1, "; ");
  return "error: " + text + " (--help tells the options)\n";
}

/// The message for a first word that is no command, or nothing.
std::string unknown_command(const CLI::App& program, int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "-";
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  if (word.rfind('-', 0) == 0 ||
      std::any_of(commands.begin(), commands.end(),
                  [&](const CLI::App* command) { return command->check_name(word); }))
    return "";
  std::string known;
  for (unsigned k = 0; k < ellipsoid::post::command_count; ++k)
    known += (k > 0 ? ", " : "") + std::string(ellipsoid::post::command_rows[k].name);
  return "unknown command '" + word + "'; the commands are " + known;
}

} // namespace

int main(int argc, char** argv) {
  using namespace ellipsoid::post;
  std::vector<std::string> words(argv, argv + argc);
  remember_command_line(words);
  std::vector<char*> arguments;
  for (std::string& word : words) {
    complete_number(word);
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  keep_free_memory();
  CLI::App program("ellipsoid-post: measures and shows what LIGGGHTS piled up, from its dumps.",
                   "ellipsoid-post");
  program.require_subcommand(1);
  program.failure_message(one_line);
  program.set_version_flag("--version", version_text());
  program.footer("ellipsoid-post COMMAND --help explains a command and its definitions.\n"
                 "Exit codes: 0 good, 1 broken or missing data, 2 wrong usage.");
  int exit_code = exit_good;
  for (unsigned k = 0; k < command_count; ++k)
    command_rows[k].add(program, exit_code);
  require_finite_numbers(program);
  try {
    program.parse(argc, arguments.data());
  } catch (const CLI::ParseError& error) {
    if (const std::string unknown = unknown_command(program, argc, argv); !unknown.empty()) {
      report_error(unknown);
      return exit_bad_usage;
    }
    return program.exit(error) == 0 ? exit_good : exit_bad_usage;
  } catch (const std::exception& error) {
    report_error(error.what());
    return exit_bad_data;
  }
  return exit_code;
}
