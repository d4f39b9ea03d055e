// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "surface_mesh.h"

#include "vtk_array.h"

#include <cstdint>
#include <fmt/format.h>

namespace ellipsoid::post {
std::string vtp_text(const SurfaceMesh& mesh) {
  std::string text = vtk_file_begin("PolyData");
  text += fmt::format("<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n<Points>\n",
                      mesh.points.size(), mesh.triangles.size());
  std::vector<double> coordinates;
  for (const Vector3& p : mesh.points)
    coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  append_vtk_array(text, "Float64", "points", 3, coordinates);
  std::vector<std::int64_t> corners, offsets;
  for (const auto& t : mesh.triangles) {
    for (const std::size_t corner : t)
      corners.push_back(static_cast<std::int64_t>(corner));
    offsets.push_back(static_cast<std::int64_t>(corners.size()));
  }
  text += "</Points>\n<Polys>\n";
  append_vtk_array(text, "Int64", "connectivity", 1, corners);
  append_vtk_array(text, "Int64", "offsets", 1, offsets);
  text += "</Polys>\n<CellData>\n";
  for (const CellValues& values : mesh.cell_values)
    append_vtk_array(text, "Float64", values.name, 1, values.values);
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

} // namespace ellipsoid::post
