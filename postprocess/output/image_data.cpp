// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "image_data.h"

#include "vtk_array.h"

#include <fmt/format.h>

namespace ellipsoid::post {

std::string vti_text(const ImageData& image) {
  const std::string extent =
      fmt::format("0 {} 0 {} 0 {}", image.counts[0] - 1, image.counts[1] - 1, image.counts[2] - 1);
  std::string text = vtk_file_begin("ImageData");
  text += fmt::format("<ImageData WholeExtent=\"{}\" Origin=\"{} {} {}\" Spacing=\"{} {} {}\">\n"
                      "<Piece Extent=\"{}\">\n<PointData>\n",
                      extent, image.origin.x, image.origin.y, image.origin.z, image.spacing.x,
                      image.spacing.y, image.spacing.z, extent);
  for (const GridValues& values : image.values)
    append_vtk_array(text, "Float64", values.name, values.components, values.values);
  return text + "</PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
}

} // namespace ellipsoid::post
