// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "option_checks.h"

#include <exception>
#include <utility>

namespace ellipsoid::post {

CLI::Validator check_by(std::function<void(const std::string&)> parse) {
  return CLI::Validator(
      [parse = std::move(parse)](const std::string& word) -> std::string {
        try {
          parse(word);
        } catch (const std::exception& error) {
          return error.what();
        }
        return "";
      },
      "");
}

void refuse_without_effect(const CLI::App& command, const std::vector<std::string>& options,
                           const std::string& reason) {
  for (const std::string& name : options)
    if (command.get_option(name)->count() > 0)
      throw CLI::ValidationError(name, "has no effect " + reason + ": leave it out");
}

} // namespace ellipsoid::post
