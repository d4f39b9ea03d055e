// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Numbers of a view as few bytes: what view/data.js reads.
#pragma once

#include "math/vector3.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Columns one behind the other, little-endian, each filled up to a multiple of four bytes.
class PackedColumns {
 public:
  void add(const std::vector<std::uint16_t>& column) { append(column); }
  void add(const std::vector<std::uint32_t>& column) { append(column); }
  void add(const std::vector<float>& column) { append(column); }

  /// Compressed (zlib, RFC 1950), as base64. Throws InputError when memory is out.
  std::string text() const;

 private:
  std::string bytes_;

  template <typename Number> void append(const std::vector<Number>& column);
};

/// A unit quaternion in three numbers of 16 bits: its parts but the largest, each 15 bits over
/// -sqrt(1/2) to sqrt(1/2); the top bits of the first two say which part is the largest (of
/// w, x, y, z), which is made positive. Error of the turn below 1e-4 rad.
std::array<std::uint16_t, 3> packed_quaternion(const Quaternion& q);

} // namespace ellipsoid::post
