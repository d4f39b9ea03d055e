// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "porosity.h"

#include "porosity_value.h"
#include "union_area.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ellipsoid::post {
namespace {

void require(const std::vector<ReposeAngle>& flanks) {
  if (flanks.empty())
    throw InputError("the regions middle and core need the fitted line A-B, but the free surface "
                     "could not be fitted; use --region whole");
}

/// Everything between two abscissas above the floor.
ConvexPolygon strip(const Pile& pile, double floor, double x0, double x1) {
  ConvexPolygon region = surrounding_rectangle(pile.outlines);
  region = clipped(region, {0.0, -1.0}, -floor);
  region = clipped(region, {-1.0, 0.0}, -x0);
  return clipped(region, {1.0, 0.0}, x1);
}

ConvexPolygon core(const Pile& pile, const PileOptions& options, double margin,
                   const std::vector<ReposeAngle>& flanks) {
  const double inner = options.wall ? pile.left + margin : pile.left;
  ConvexPolygon region = strip(pile, options.floor + margin, inner, pile.right);
  for (const ReposeAngle& flank : flanks) {
    // below the line y = intercept + slope x, moved down by the margin across it
    const double slope = flank.line.slope, length = std::hypot(1.0, slope);
    const Point upward(-slope / length, 1.0 / length);
    region = clipped(region, upward, flank.line.intercept / length - margin);
  }
  return region;
}

/// Abscissas between which the region lies.
std::pair<double, double> extent(const Pile& pile, PorosityRegion region,
                                 const std::vector<ReposeAngle>& flanks) {
  if (region == PorosityRegion::whole)
    return {pile.left, pile.right};
  double left = pile.right, right = pile.left;
  for (const ReposeAngle& flank : flanks) {
    left = std::min({left, flank.a.x(), flank.b.x()});
    right = std::max({right, flank.a.x(), flank.b.x()});
  }
  return {left, right};
}

/// Pairs of outlines that may overlap: those of particles that are near each other, where every
/// particle has one outline.
OutlinePairs pairs_of_outlines(const Pile& pile) {
  const bool is_one_each = std::equal(
      pile.members.begin(), pile.members.end(), pile.outlines.begin(), pile.outlines.end(),
      [](std::size_t member, const PlaneEllipse& shape) { return member == shape.owner; });
  if (!is_one_each)
    return near_outlines(pile.outlines);
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> outline_of(pile.members.back() + 1, none);
  for (std::size_t k = 0; k < pile.members.size(); ++k)
    outline_of[pile.members[k]] = k;
  OutlinePairs pairs;
  pairs.reserve(pile.near.pairs().size());
  for (const auto& [i, j] : pile.near.pairs())
    if (j < outline_of.size() && outline_of[i] != none && outline_of[j] != none)
      pairs.emplace_back(outline_of[i], outline_of[j]);
  return pairs;
}

} // namespace

Porosity plane_porosity(const Pile& pile, const PileOptions& pile_options,
                        const PorosityOptions& options, const std::vector<ReposeAngle>& flanks) {
  if (options.region != PorosityRegion::whole)
    require(flanks);
  ConvexPolygon region;
  Porosity result;
  if (options.region == PorosityRegion::core) {
    region = core(pile, pile_options, options.margin * pile.mean_a, flanks);
    result.total_area = polygon_area(region);
  } else {
    const auto [x0, x1] = extent(pile, options.region, flanks);
    region = strip(pile, pile_options.floor, x0, x1);
    result.total_area = pile.surface.area(x0, x1);
  }
  if (!(result.total_area > 0.0))
    throw InputError("the region for the porosity is empty: the pile is too small for it; "
                     "use --region whole or a smaller --margin");
  const UnionMeasures measures = union_in_region(pile.outlines, region, pairs_of_outlines(pile));
  result.solid_area = measures.area;
  result.area_sum = measures.area_sum;
  result.porosity = porosity_of(result.solid_area, result.total_area);
  if (result.area_sum <= result.total_area)
    result.porosity_by_sum = porosity_of(result.area_sum, result.total_area);
  result.overlap_share = measures.area_sum > 0.0 ? 1.0 - measures.area / measures.area_sum : 0.0;
  return result;
}

} // namespace ellipsoid::post
