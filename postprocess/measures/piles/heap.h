// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "height_map.h"
#include "spread.h"

namespace ellipsoid::post {

struct HeapOptions {
  int sectors = 12;
  double cut_bottom = 0.2, cut_top = 0.2; ///< shares of the height left out of the fit
  double column_width = 0.25;             ///< of the mean smallest semi-axis
  double floor = 0.0;                     ///< z (length)
  double cluster_gap = 0.1;               ///< as for in-plane piles
};

struct HeapAngle {
  double axis_x = 0.0, axis_y = 0.0; ///< of the cone, found from the data (length)
  double height = 0.0;               ///< mean height around the axis (length)
  std::vector<double> sector_angles_deg;
  Spread spread;              ///< of the sectors' angles (deg)
  double standard_error = 0.; ///< standard deviation over sectors / sqrt(sectors) (deg)
  std::size_t members = 0, strays = 0;
  double volume = 0.0; ///< between floor and free surface (length^3)
  /// Part of the heap's radius, out to B, that the line goes over, mean over sectors; of a cone
  /// 1 - cut_top / (1 - cut_bottom).
  double line_share = 0.0;
};

/// Angle of repose of a heap on a floor; z points up.
///
/// The heap is the largest cluster of connected particles. Its axis is the centroid of the free
/// surface's volume. The floor plan is divided into equal sectors about it; in each, rings one
/// mean largest semi-axis wide give a radial profile of mean heights. With H the largest of all
/// rings, the least squares line goes through the profile from the outermost ring with height >=
/// (1 - cut_top) H to the outermost one with height >= cut_bottom H.
/// Throws InputError when a sector has less than 3 rings there.
HeapAngle heap_angle(const ParticleSet& upright, const HeapOptions& options);

/// Members of the largest connected cluster (see PileOptions::cluster_gap).
std::vector<std::size_t> largest_cluster(const ParticleSet& set, double gap_in_b);

} // namespace ellipsoid::post
