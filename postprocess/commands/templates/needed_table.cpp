// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid_counts.h"
#include "input_error.h"
#include "messages.h"
#include "multisphere/ellipsoid_spheres.h"
#include "progress_line.h"
#include "set_comparison.h"
#include "sphere_sets.h"

#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <utility>

namespace ellipsoid::post {
namespace {

/// No value where no number is enough.
Value number_needed(const Vector3& semiaxes, SphereSpacing spacing, double share) {
  try {
    return static_cast<std::int64_t>(count_within(semiaxes, spacing, SetError::volume, share));
  } catch (const std::invalid_argument&) {
    return {};
  }
}

std::string name_of(const Vector3& shape) {
  return fmt::format("1 : {:g} : {:g}", shape.y, shape.z);
}

/// Shapes a = 1 >= b >= c < a of these ratios.
std::vector<Vector3> shapes_of(const std::vector<double>& ratios) {
  std::vector<Vector3> shapes;
  for (const double b : ratios)
    for (const double c : ratios)
      if (c <= b && c < 1.0)
        shapes.push_back({1.0, b, c});
  if (shapes.empty())
    throw InputError(
        "--ratios: no ratio is below 1, and a = b = c is a sphere: give a smaller one");
  return shapes;
}

Row shape_columns(const Vector3& shape) {
  return {{"shape", "a : b : c", "", name_of(shape)},
          {"b_a", "b/a", "", shape.y},
          {"c_a", "c/a", "", shape.z}};
}

} // namespace

Table needed_table(double share, const std::vector<double>& ratios) {
  Table table{"Sub-spheres needed", {}};
  for (const Vector3& shape : shapes_of(ratios)) {
    show_progress_line("N needed for " + name_of(shape));
    table.rows.push_back(
        {{"b_a", "b/a", "", shape.y},
         {"c_a", "c/a", "", shape.z},
         {"medial", "medial", "", number_needed(shape, SphereSpacing::medial, share)},
         {"minimax_volume", "minimax_volume", "",
          number_needed(shape, SphereSpacing::minimax_volume, share)}});
  }
  clear_progress_line();
  return table;
}

Table ratio_table(const std::vector<double>& ratios, const std::vector<int>& counts,
                  SphereSpacing spacing) {
  Table table{"Sets of spheres over b/a and c/a", {}};
  for (const Vector3& shape : shapes_of(ratios))
    for (const int count : counts) {
      show_progress_line(fmt::format("{}, N = {}", name_of(shape), count));
      Row row = shape_columns(shape);
      row.push_back({"subspheres", "N", "", static_cast<std::int64_t>(count)});
      row.push_back({"spacing", "spacing", "", word_of(spacing)});
      try {
        const SphereSet set = make_ellipsoid_spheres(shape, count, spacing);
        append_comparison(row, measure_union(set), set,
                          {solid_ellipsoid(shape), shape.z, "c", shape});
      } catch (const std::invalid_argument& error) {
        clear_progress_line();
        report_warning(error.what());
        continue;
      }
      table.rows.push_back(std::move(row));
    }
  clear_progress_line();
  if (table.rows.empty())
    throw InputError("none of these templates can be built");
  return table;
}

} // namespace ellipsoid::post
