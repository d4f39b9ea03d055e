// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "input_error.h"

#include <fmt/format.h>

namespace ellipsoid::post {

InputError unexpected(const FileLocation& location, const std::string& expected,
                      const std::string& found) {
  std::string text = location.file + ":";
  if (location.line > 0)
    text += fmt::format("{}:", location.line);
  if (location.frame > 0)
    text += fmt::format(" frame {}:", location.frame);
  return InputError(fmt::format("{} expected {}, found {}", text, expected, found));
}

BrokenLine::BrokenLine(const FileLocation& where, const std::string& what_expected,
                       const std::string& what_found)
    : InputError(unexpected(where, what_expected, what_found)), location(where),
      expected(what_expected), found(what_found) {}

std::string quoted(const std::string& text) {
  constexpr std::size_t longest = 40;
  std::string shown = "\"";
  for (const char letter : text.substr(0, longest)) {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x20 || code >= 0x7f)
      shown += fmt::format("\\x{:02x}", code);
    else
      shown += letter;
  }
  return shown + (text.size() > longest ? "...\"" : "\"");
}

} // namespace ellipsoid::post
