// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "surface_mesh.h"

#include "base64.h"
#include "input_error.h"

#include <cstdint>
#include <fmt/format.h>
#include <zlib.h>

namespace ellipsoid::post {
namespace {

/// A data array of VTK's XML formats: base64 of a header (number of blocks, size of a block, size
/// of the last block if shorter, compressed size) and of the one block compressed by zlib.
template <class Number>
void append_array(std::string& text, const char* type, const std::string& name, int components,
                  const std::vector<Number>& values) {
  const uLong size = static_cast<uLong>(values.size() * sizeof(Number));
  uLongf packed_size = compressBound(size);
  std::string packed(packed_size, '\0');
  if (compress(reinterpret_cast<unsigned char*>(packed.data()), &packed_size,
               reinterpret_cast<const unsigned char*>(values.data()), size) != Z_OK)
    throw InputError("the surface cannot be compressed");
  packed.resize(packed_size);
  const std::uint64_t header[4] = {1, size, 0, packed_size};
  const std::string header_bytes(reinterpret_cast<const char*>(header), sizeof(header));
  text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                      "format=\"binary\">\n{}{}\n</DataArray>\n",
                      type, name, components, base64(header_bytes), base64(packed));
}

std::string xml_safe(const std::string& name) {
  std::string safe;
  for (const char letter : name)
    safe += letter == '<' || letter == '>' || letter == '&' || letter == '"' ? '_' : letter;
  return safe;
}

} // namespace

std::string vtp_text(const SurfaceMesh& mesh) {
  std::string text =
      fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                  "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
                  "compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n"
                  "<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n<Points>\n",
                  mesh.points.size(), mesh.triangles.size());
  std::vector<double> coordinates;
  for (const Vector3& p : mesh.points)
    coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  append_array(text, "Float64", "points", 3, coordinates);
  std::vector<std::int64_t> corners, offsets;
  for (const auto& t : mesh.triangles) {
    for (const std::size_t corner : t)
      corners.push_back(static_cast<std::int64_t>(corner));
    offsets.push_back(static_cast<std::int64_t>(corners.size()));
  }
  text += "</Points>\n<Polys>\n";
  append_array(text, "Int64", "connectivity", 1, corners);
  append_array(text, "Int64", "offsets", 1, offsets);
  text += "</Polys>\n<CellData>\n";
  for (const CellValues& values : mesh.cell_values)
    append_array(text, "Float64", xml_safe(values.name), 1, values.values);
  return text + "</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string stl_text(const SurfaceMesh& mesh) {
  std::string text = "solid particle\n";
  for (const auto& t : mesh.triangles) {
    const Vector3 &p = mesh.points[t[0]], &q = mesh.points[t[1]], &r = mesh.points[t[2]];
    const Vector3 n = cross(q - p, r - p);
    const double length = norm(n);
    const Vector3 unit = length > 0.0 ? (1.0 / length) * n : n;
    text += fmt::format("facet normal {} {} {}\nouter loop\n", unit.x, unit.y, unit.z);
    for (const Vector3* corner : {&p, &q, &r})
      text += fmt::format("vertex {} {} {}\n", corner->x, corner->y, corner->z);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid particle\n";
}

double enclosed_volume(const SurfaceMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
    volume += dot(mesh.points[t[0]], cross(mesh.points[t[1]], mesh.points[t[2]])) / 6.0;
  return volume;
}

} // namespace ellipsoid::post
