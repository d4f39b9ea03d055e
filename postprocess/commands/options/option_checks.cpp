// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "option_checks.h"

#include "input_error.h"

#include <exception>
#include <fmt/format.h>
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

void require_ascending_pairs(const std::string& option, const std::vector<double>& bounds,
                             EqualBounds equal) {
  const bool may_be_equal = equal == EqualBounds::allowed;
  for (std::size_t k = 0; k + 1 < bounds.size(); k += 2)
    if (!(bounds[k] < bounds[k + 1] || (may_be_equal && bounds[k] == bounds[k + 1])))
      throw InputError(fmt::format("{} needs the lower bound first ({} the upper one), found {} {}",
                                   option, may_be_equal ? "<=" : "<", bounds[k], bounds[k + 1]));
}

} // namespace ellipsoid::post
