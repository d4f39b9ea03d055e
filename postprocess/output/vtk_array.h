// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What all of VTK's XML files are made of.
#pragma once

#include "base64.h"
#include "input_error.h"

#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <vector>
#include <zlib.h>

namespace ellipsoid::post {

/// The first lines of a compressed file of this type.
inline std::string vtk_file_begin(const std::string& type) {
  return fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" "
                     "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
                     "compressor=\"vtkZLibDataCompressor\">\n",
                     type);
}

inline std::string xml_safe(const std::string& name) {
  std::string safe;
  for (const char letter : name)
    safe += letter == '<' || letter == '>' || letter == '&' || letter == '"' ? '_' : letter;
  return safe;
}

/// A data array: base64 of a header (number of blocks, size of a block, size of the last block if
/// shorter, compressed size) and of the one block compressed by zlib.
template <class Number>
void append_vtk_array(std::string& text, const char* type, const std::string& name, int components,
                      const std::vector<Number>& values) {
  const uLong size = static_cast<uLong>(values.size() * sizeof(Number));
  uLongf packed_size = compressBound(size);
  std::string packed(packed_size, '\0');
  if (compress(reinterpret_cast<unsigned char*>(packed.data()), &packed_size,
               reinterpret_cast<const unsigned char*>(values.data()), size) != Z_OK)
    throw InputError("the values cannot be compressed");
  packed.resize(packed_size);
  const std::uint64_t header[4] = {1, size, 0, packed_size};
  const std::string header_bytes(reinterpret_cast<const char*>(header), sizeof(header));
  text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                      "format=\"binary\">\n{}{}\n</DataArray>\n",
                      type, xml_safe(name), components, base64(header_bytes), base64(packed));
}

} // namespace ellipsoid::post
