// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "surface_mesh.h"

#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

void append_array(std::string& text, const char* type, const std::string& name, int components) {
  text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                      "format=\"ascii\">\n",
                      type, name, components);
}

std::string xml_safe(const std::string& name) {
  std::string safe;
  for (const char letter : name)
    safe += letter == '<' || letter == '>' || letter == '&' || letter == '"' ? '_' : letter;
  return safe;
}

} // namespace

std::string vtp_text(const SurfaceMesh& mesh) {
  std::string text = fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" "
                                 "version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
                                 "<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n<Points>\n",
                                 mesh.points.size(), mesh.triangles.size());
  append_array(text, "Float64", "points", 3);
  for (const Vector3& p : mesh.points)
    text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
  text += "</DataArray>\n</Points>\n<Polys>\n";
  append_array(text, "Int64", "connectivity", 1);
  for (const auto& t : mesh.triangles)
    text += fmt::format("{} {} {}\n", t[0], t[1], t[2]);
  text += "</DataArray>\n";
  append_array(text, "Int64", "offsets", 1);
  for (std::size_t k = 1; k <= mesh.triangles.size(); ++k)
    text += fmt::format("{}\n", 3 * k);
  text += "</DataArray>\n</Polys>\n<CellData>\n";
  for (const CellValues& values : mesh.cell_values) {
    append_array(text, "Float64", xml_safe(values.name), 1);
    for (const double value : values.values)
      text += fmt::format("{}\n", value);
    text += "</DataArray>\n";
  }
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
