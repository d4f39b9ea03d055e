// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "view_data.h"

#include "base64.h"
#include "input_error.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <zlib.h>

namespace ellipsoid::post {

template <typename Number> void PackedColumns::append(const std::vector<Number>& column) {
  using Bits = std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint32_t>;
  for (const Number number : column) {
    Bits bits;
    std::memcpy(&bits, &number, sizeof(bits));
    for (std::size_t k = 0; k < sizeof(bits); ++k)
      bytes_ += static_cast<char>(bits >> (8 * k) & 0xffu);
  }
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
}

template void PackedColumns::append(const std::vector<std::uint16_t>&);
template void PackedColumns::append(const std::vector<std::uint32_t>&);
template void PackedColumns::append(const std::vector<float>&);

std::string PackedColumns::text() const {
  uLongf size = compressBound(static_cast<uLong>(bytes_.size()));
  std::string packed(size, '\0');
  if (compress(reinterpret_cast<unsigned char*>(packed.data()), &size,
               reinterpret_cast<const unsigned char*>(bytes_.data()),
               static_cast<uLong>(bytes_.size())) != Z_OK)
    throw InputError("the view cannot be compressed: not enough memory; choose fewer frames");
  packed.resize(size);
  return base64(packed);
}

std::array<std::uint16_t, 3> packed_quaternion(const Quaternion& q) {
  const std::array<double, 4> parts = {q.w, q.x, q.y, q.z};
  const auto largest = static_cast<unsigned>(
      std::max_element(parts.begin(), parts.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      parts.begin());
  const double sign = parts[largest] < 0.0 ? -1.0 : 1.0;
  std::array<std::uint16_t, 3> packed{};
  unsigned next = 0;
  for (unsigned k = 0; k < 4; ++k)
    if (k != largest) {
      const double share = 0.5 + 0.5 * std::sqrt(2.0) * sign * parts[k];
      packed[next++] =
          static_cast<std::uint16_t>(std::lround(32767.0 * std::clamp(share, 0.0, 1.0)));
    }
  packed[0] = static_cast<std::uint16_t>(packed[0] | (largest & 1u) << 15);
  packed[1] = static_cast<std::uint16_t>(packed[1] | (largest >> 1) << 15);
  return packed;
}

} // namespace ellipsoid::post
