// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "input_error.h"

#include <fmt/format.h>

namespace ellipsoid::post {

InputError unexpected(const FilePlace& place, const std::string& expected,
                      const std::string& found) {
  return InputError(fmt::format("{}:{}: frame {}: expected {}, found {}", place.file, place.line,
                                place.frame, expected, found));
}

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
