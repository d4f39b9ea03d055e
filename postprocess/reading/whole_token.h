// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace ellipsoid::post {

/// The number that a whole text is; nothing where it is none, or more than one.
template <class Number> std::optional<Number> whole_token(std::string_view text) {
  Number value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size())
    return std::nullopt;
  return value;
}

} // namespace ellipsoid::post
