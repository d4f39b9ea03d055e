// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Where the command `fields` takes fields: a grid, a profile, or points.
#pragma once

#include "command.h"
#include "field_rows.h"
#include "field_targets.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

struct FieldPointOptions {
  std::vector<int> grid;
  std::string profile, axis = "z";
  std::vector<double> at, box, cylinder;
  int slices = 50;
};

void add_field_point_options(CLI::App& command, FieldPointOptions& options);

/// The points, fixed when the first frame is known.
class FieldPoints {
 public:
  /// @param[in] width of the coarse-graining function (length)
  /// Throws InputError for options that do not belong together.
  FieldPoints(const FieldPointOptions& options, const Box& box, double width);

  /// Targets for one frame, whose sums() go with gathered().
  std::unique_ptr<FieldTargets> targets(const CoarseGrainingFunction& function,
                                        const PeriodicCell& cell, double longest) const;
  /// Sums of the targets, one per point: rings are averaged in cylindrical components.
  std::vector<FieldSums> gathered(const std::vector<FieldSums>& sums) const;

  std::size_t count() const { return rows_.size(); }
  /// Columns that tell where the point is.
  const Row& row(std::size_t point) const { return rows_[point]; }
  const ComponentNames& component_names() const { return names_; }
  bool is_grid() const { return image_.counts[0] > 0; }
  /// The grid without values.
  const ImageData& image() const { return image_; }

 private:
  void set_points(const std::vector<double>& coordinates);
  void set_grid(const std::vector<int>& counts, const Box& box);
  void set_planes(std::size_t axis, int slices, const Box& box, bool is_part);
  void set_rings(const FieldPointOptions& options, double width);

  std::vector<Vector3> points_;
  std::vector<std::size_t> place_of_point_; ///< rings only
  std::vector<Rotation3> axes_of_point_;    ///< rings only
  std::optional<std::size_t> plane_axis_;
  std::vector<double> abscissae_;
  std::optional<Box> section_;
  std::vector<Row> rows_;
  ComponentNames names_{"x", "y", "z"};
  ImageData image_;
};

} // namespace ellipsoid::post
