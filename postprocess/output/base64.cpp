// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "base64.h"

#include <cstdint>

namespace ellipsoid::post {

std::string base64(const std::string& bytes) {
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i)
      group = group << 8 | (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i)
      text += k + i > bytes.size() ? '=' : letters[group >> (18 - 6 * i) & 63u];
  }
  return text;
}

} // namespace ellipsoid::post
