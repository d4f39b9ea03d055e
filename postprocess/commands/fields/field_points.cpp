// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "field_points.h"

#include "input_error.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

Row place_row(const Vector3& p) {
  return {{"x_m", "x", "m", p.x}, {"y_m", "y", "m", p.y}, {"z_m", "z", "m", p.z}};
}

Box box_of(const std::vector<double>& bounds) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.lower[k] = bounds[2 * k];
    box.upper[k] = bounds[2 * k + 1];
    if (!(box.lower[k] < box.upper[k]))
      throw InputError("--box needs x0 < x1, y0 < y1 and z0 < z1");
  }
  return box;
}

/// Unit vector along x, y or z.
Vector3 unit(std::size_t k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }

std::size_t number_of_axis(const std::string& word) {
  return word == "x" ? 0 : word == "y" ? 1 : 2;
}

} // namespace

void add_field_point_options(CLI::App& command, FieldPointOptions& options) {
  auto* grid = command.add_option("--grid", options.grid, "numbers of points along x, y, z");
  grid->expected(3)->check(CLI::Range(1, 10000));
  auto* profile = command.add_option("--profile", options.profile,
                                     "averages over planes across x, y, z, or over rings");
  profile->check(CLI::IsMember({"x", "y", "z", "radius"}))->excludes(grid);
  command.add_option("--at", options.at, "points: x y z, and more of them")
      ->excludes(grid)
      ->excludes(profile);
  command.add_option("--slices", options.slices, "points of the profile")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  auto* box = command.add_option(
      "--box", options.box, "x0 x1 y0 y1 z0 z1: the part of space (default: the box of the file)");
  box->expected(6);
  command
      .add_option("--cylinder", options.cylinder,
                  "the rings' axis (two coordinates), radius, and both ends along the axis")
      ->expected(5)
      ->needs(profile)
      ->excludes(box);
  command.add_option("--axis", options.axis, "direction of the cylinder's axis: x, y or z")
      ->check(CLI::IsMember({"x", "y", "z"}))
      ->capture_default_str();
}

FieldPoints::FieldPoints(const FieldPointOptions& options, const Box& box, double width) {
  const Box part = options.box.empty() ? box : box_of(options.box);
  if (!options.at.empty())
    set_points(options.at);
  else if (!options.grid.empty() && options.box.empty() && !box.tilted_edges.empty())
    throw InputError("a grid in a tilted box needs --box");
  else if (!options.grid.empty())
    set_grid(options.grid, part);
  else if (options.profile == "radius")
    set_rings(options, width);
  else if (!options.profile.empty())
    set_planes(number_of_axis(options.profile), options.slices, part, !options.box.empty());
  else
    throw InputError("say where: --grid nx ny nz, --profile x|y|z|radius, or --at x y z");
}

void FieldPoints::set_points(const std::vector<double>& coordinates) {
  if (coordinates.size() % 3 != 0)
    throw InputError("--at needs three numbers for each point");
  for (std::size_t k = 0; k < coordinates.size(); k += 3) {
    points_.push_back({coordinates[k], coordinates[k + 1], coordinates[k + 2]});
    rows_.push_back(place_row(points_.back()));
  }
}

/// Points in the middles of equal boxes: sums over them times a box's volume are integrals.
void FieldPoints::set_grid(const std::vector<int>& counts, const Box& box) {
  double step[3];
  for (std::size_t k = 0; k < 3; ++k) {
    step[k] = (box.upper[k] - box.lower[k]) / counts[k];
    image_.counts[k] = counts[k];
  }
  image_.spacing = {step[0], step[1], step[2]};
  image_.origin = Vector3{box.lower[0], box.lower[1], box.lower[2]} + 0.5 * image_.spacing;
  for (int k = 0; k < counts[2]; ++k)
    for (int j = 0; j < counts[1]; ++j)
      for (int i = 0; i < counts[0]; ++i) {
        points_.push_back(image_.origin + Vector3{i * step[0], j * step[1], k * step[2]});
        rows_.push_back(place_row(points_.back()));
      }
}

void FieldPoints::set_planes(std::size_t axis, int slices, const Box& box, bool is_part) {
  const std::string name = names_[axis];
  plane_axis_ = axis;
  if (is_part)
    section_ = box;
  const double step = (box.upper[axis] - box.lower[axis]) / slices;
  for (int k = 0; k < slices; ++k) {
    abscissae_.push_back(box.lower[axis] + (k + 0.5) * step);
    rows_.push_back({{name + "_m", name, "m", abscissae_.back()}});
  }
}

/// Points on circles, half a width apart: smooth functions are then integrated to rounding around
/// the axis.
void FieldPoints::set_rings(const FieldPointOptions& options, double width) {
  const std::vector<double>& c = options.cylinder;
  if (c.size() != 5 || !(c[2] > 0.0) || !(c[3] < c[4]))
    throw InputError("a profile over the radius needs --cylinder with a radius > 0 and ends in "
                     "ascending order");
  constexpr double apart = 0.5; // widths
  constexpr int fewest = 8;
  const std::size_t along = number_of_axis(options.axis);
  const Vector3 first = unit((along + 1) % 3), second = unit((along + 2) % 3), axis = unit(along);
  const int layers = std::max(fewest, static_cast<int>(std::ceil((c[4] - c[3]) / (apart * width))));
  names_ = {"r", "t", options.axis};
  for (int slice = 0; slice < options.slices; ++slice) {
    const double radius = (slice + 0.5) * c[2] / options.slices;
    const int turns =
        std::max(fewest, static_cast<int>(std::ceil(2.0 * pi * radius / (apart * width))));
    for (int k = 0; k < turns * layers; ++k) {
      const double angle = 2.0 * pi * (k % turns) / turns;
      const double height = c[3] + (k / turns + 0.5) * (c[4] - c[3]) / layers;
      const Vector3 outward = std::cos(angle) * first + std::sin(angle) * second;
      points_.push_back(c[0] * first + c[1] * second + radius * outward + height * axis);
      axes_of_point_.push_back({outward, cross(axis, outward), axis});
      place_of_point_.push_back(rows_.size());
    }
    rows_.push_back({{"radius_m", "radius", "m", radius}});
  }
}

std::unique_ptr<FieldTargets> FieldPoints::targets(const CoarseGrainingFunction& function,
                                                   const PeriodicCell& cell, double longest) const {
  if (plane_axis_)
    return plane_targets(*plane_axis_, abscissae_, section_, function, cell, longest);
  return point_targets(points_, function, cell, longest);
}

std::vector<FieldSums> FieldPoints::gathered(const std::vector<FieldSums>& sums) const {
  if (place_of_point_.empty())
    return sums;
  std::vector<FieldSums> means(rows_.size(), FieldSums{});
  std::vector<double> counts(rows_.size(), 0.0);
  for (std::size_t n = 0; n < sums.size(); ++n) {
    const FieldSums local = turned(sums[n], axes_of_point_[n]);
    for (std::size_t k = 0; k < field_size; ++k)
      means[place_of_point_[n]][k] += local[k];
    counts[place_of_point_[n]] += 1.0;
  }
  for (std::size_t point = 0; point < means.size(); ++point)
    for (double& value : means[point])
      value /= counts[point];
  return means;
}

} // namespace ellipsoid::post
