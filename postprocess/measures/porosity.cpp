// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "porosity.h"

#include "union_area.h"

#include <cmath>

namespace ellipsoid::post {
namespace {

const ReposeAngle& needed(const std::optional<ReposeAngle>& angle) {
  if (!angle)
    throw InputError("the regions middle and core need the fitted line A-B, but the free surface "
                     "could not be fitted; use --region whole");
  return *angle;
}

/// Everything between two abscissas above the floor.
ConvexPolygon strip(const Pile& pile, double floor, double x0, double x1) {
  ConvexPolygon region = surrounding_rectangle(pile.outlines);
  region = clipped(region, {0.0, -1.0}, -floor);
  region = clipped(region, {-1.0, 0.0}, -x0);
  return clipped(region, {1.0, 0.0}, x1);
}

ConvexPolygon core(const Pile& pile, const PileOptions& options, double margin,
                   const ReposeAngle& angle) {
  const double inner = options.wall ? pile.left + margin : angle.a.x();
  ConvexPolygon region = strip(pile, options.floor + margin, inner, pile.right);
  // below the line y = intercept + slope x, moved down by the margin across it
  const double slope = angle.line.slope, length = std::hypot(1.0, slope);
  const Point upward(-slope / length, 1.0 / length);
  return clipped(region, upward, angle.line.intercept / length - margin);
}

} // namespace

Porosity plane_porosity(const Pile& pile, const PileOptions& pile_options,
                        const PorosityOptions& options, const std::optional<ReposeAngle>& angle) {
  ConvexPolygon region;
  Porosity result;
  if (options.region == PorosityRegion::core) {
    region = core(pile, pile_options, options.margin * pile.mean_a, needed(angle));
    result.total_area = polygon_area(region);
  } else {
    const bool is_whole = options.region == PorosityRegion::whole;
    const double x0 = is_whole ? pile.left : std::min(needed(angle).a.x(), angle->b.x());
    const double x1 = is_whole ? pile.right : std::max(angle->a.x(), angle->b.x());
    region = strip(pile, pile_options.floor, x0, x1);
    result.total_area = pile.surface.area(x0, x1);
  }
  if (!(result.total_area > 0.0))
    throw InputError("the region for the porosity is empty: the pile is too small for it; "
                     "use --region whole or a smaller --margin");
  const UnionMeasures measures = union_in_region(pile.outlines, region);
  result.solid_area = measures.area;
  result.area_sum = measures.area_sum;
  result.porosity = 1.0 - result.solid_area / result.total_area;
  result.porosity_by_sum = 1.0 - result.area_sum / result.total_area;
  result.overlap_share = measures.area_sum > 0.0 ? 1.0 - measures.area / measures.area_sum : 0.0;
  return result;
}

} // namespace ellipsoid::post
