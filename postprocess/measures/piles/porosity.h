// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "pile.h"
#include "repose.h"

#include <optional>
#include <vector>

namespace ellipsoid::post {

/// Which part of the pile is measured.
enum class PorosityRegion {
  whole,  ///< between wall, floor and free surface over the pile's whole extent
  middle, ///< the same, but only between the abscissas of A and B (both B of a two-sided pile)
  core,   ///< at least `margin` away from wall and floor and below the fitted lines A-B
};

struct PorosityOptions {
  PorosityRegion region = PorosityRegion::whole;
  double margin = 2.0; ///< of the core, in mean largest semi-axes a
};

struct Porosity {
  double porosity = 0.0; ///< 1 - solid / total: overlaps counted once
  /// 1 - area_sum / total, as the paper adds section areas; none where the sum exceeds the total
  std::optional<double> porosity_by_sum;
  double total_area = 0.0;    ///< of the region (length^2)
  double solid_area = 0.0;    ///< of the union of the outlines in it (length^2)
  double area_sum = 0.0;      ///< of the outlines one by one in it (length^2)
  double overlap_share = 0.0; ///< (area_sum - solid_area) / area_sum
};

/// In-plane porosity (paper, section 4.2.2), exact for the outlines of `pile`.
/// @param[in] flanks needed for the regions middle and core: the one beside the wall, or both
/// Throws InputError when the region is empty.
Porosity plane_porosity(const Pile& pile, const PileOptions& pile_options,
                        const PorosityOptions& options, const std::vector<ReposeAngle>& flanks);

} // namespace ellipsoid::post
