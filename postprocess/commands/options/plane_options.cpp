// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "plane_options.h"

namespace ellipsoid::post {

void add_fit_options(CLI::App& command, PlaneOptions& plane) {
  PileOptions& options = plane.pile;
  command
      .add_option("--cut-bottom", options.cut_bottom,
                  "share of the height left out of the fit at the bottom")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  command
      .add_option("--cut-top", options.cut_top,
                  "share of the height left out of the fit at the top")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  command
      .add_option("--columns", options.column_spacing,
                  "distance of the columns of the free surface, in mean smallest semi-axes b")
      ->check(CLI::Range(1e-4, 1.0))
      ->capture_default_str();
}

void add_plane_options(CLI::App& command, PlaneOptions& options) {
  auto* wall = command.add_option("--wall", options.wall, "abscissa x of the wall on the left");
  wall->capture_default_str();
  command.add_flag("--no-wall", options.no_wall, "a free, two-sided pile")->excludes(wall);
  command.add_option("--floor", options.pile.floor, "ordinate y of the floor")
      ->capture_default_str();
  command.add_option("--section", options.pile.section, "z of the plane (default: mean z)");
  command
      .add_option("--cluster-gap", options.pile.cluster_gap,
                  "particles this close (in b) belong to one pile")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  command
      .add_option("--outline", options.outline,
                  "true: discs of multi-sphere particles (MS); ellipse: always the "
                  "circumscribed ellipse (MS ellipse)")
      ->check(CLI::IsMember({"true", "ellipse"}))
      ->capture_default_str();
}

PileOptions plane_settings(const PlaneOptions& options) {
  PileOptions pile = options.pile;
  pile.wall = options.no_wall ? std::nullopt : std::optional<double>(options.wall);
  pile.outline =
      options.outline == "ellipse" ? OutlineKind::smooth_ellipse : OutlineKind::true_shape;
  return pile;
}

} // namespace ellipsoid::post
