// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "command_line.h"

#include <utility>

namespace ellipsoid::post {
namespace {

std::vector<std::string>& words() {
  static std::vector<std::string> remembered;
  return remembered;
}

bool is_plain(const std::string& word) {
  constexpr const char* letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                  "_-+./,:=@%^";
  return !word.empty() && word.find_first_not_of(letters) == std::string::npos;
}

/// In single quotes where the shell would read more than the word.
std::string quoted(const std::string& word) {
  if (is_plain(word))
    return word;
  std::string text = "'";
  for (const char letter : word)
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

} // namespace

void remember_command_line(std::vector<std::string> given) { words() = std::move(given); }

std::string command_line() {
  std::string line;
  for (const std::string& word : words())
    line += (line.empty() ? "" : " ") + quoted(word);
  return line;
}

} // namespace ellipsoid::post
