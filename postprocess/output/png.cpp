// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "png.h"

#include "input_error.h"

#include <zlib.h>

namespace ellipsoid::post {
namespace {

void append_number(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(value >> shift & 0xffu);
}

/// Length, type, data and checksum (PNG specification, 5.3).
void append_chunk(std::string& bytes, const std::string& type, const std::string& data) {
  append_number(bytes, static_cast<std::uint32_t>(data.size()));
  const std::string body = type + data;
  bytes += body;
  append_number(bytes, static_cast<std::uint32_t>(
                           crc32(0, reinterpret_cast<const unsigned char*>(body.data()),
                                 static_cast<unsigned>(body.size()))));
}

/// Scan lines, each behind filter type 0, compressed.
std::string compressed_lines(const PixelImage& image) {
  std::string lines;
  const std::size_t stride = 3 * image.width;
  for (std::size_t row = 0; row < image.height; ++row) {
    lines += '\0';
    lines.append(reinterpret_cast<const char*>(image.samples.data()) + row * stride, stride);
  }
  uLongf size = compressBound(static_cast<uLong>(lines.size()));
  std::string compressed(size, '\0');
  if (compress(reinterpret_cast<unsigned char*>(compressed.data()), &size,
               reinterpret_cast<const unsigned char*>(lines.data()),
               static_cast<uLong>(lines.size())) != Z_OK)
    throw InputError("the picture cannot be compressed");
  compressed.resize(size);
  return compressed;
}

} // namespace

std::string png_bytes(const PixelImage& image) {
  std::string header;
  append_number(header, static_cast<std::uint32_t>(image.width));
  append_number(header, static_cast<std::uint32_t>(image.height));
  header += std::string("\x08\x02\0\0\0", 5); // 8 bits, true colour
  std::string bytes("\x89PNG\r\n\x1a\n", 8);
  append_chunk(bytes, "IHDR", header);
  append_chunk(bytes, "IDAT", compressed_lines(image));
  append_chunk(bytes, "IEND", "");
  return bytes;
}

} // namespace ellipsoid::post
