// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "set_comparison.h"

namespace ellipsoid::post {

void append_comparison(Row& row, const UnionMeasures& m, const SphereSet& set,
                       const Target& target) {
  const Solid& solid = *target.solid;
  const OutlineDistances d = outline_distances(set, solid);
  const auto length = [&](const char* key, const char* name, double value) {
    row.push_back(
        {std::string(key) + "_" + target.unit_name, name, target.unit_name, value / target.unit});
  };
  row.push_back({"volume_ratio", "volume ratio", "", m.volume / solid.volume});
  row.push_back({"surface_ratio", "surface ratio", "", m.surface / solid.surface});
  row.push_back({"in_exactly_one", "volume in exactly one", "",
                 share_in_exactly_one(set, solid, comparison_columns)});
  length("largest_to_spheres", "outline to spheres, largest", d.largest_to_spheres);
  length("mean_to_spheres", "outline to spheres, mean", d.mean_to_spheres);
  length("rms_to_spheres", "outline to spheres, rms", d.rms_to_spheres);
  length("largest_to_body", "spheres to outline, largest", d.largest_to_solid);
  length("mean_to_body", "spheres to outline, mean", d.mean_to_solid);
  length("rms_to_body", "spheres to outline, rms", d.rms_to_solid);
  if (target.semiaxes) {
    const SectionFactors factors = section_factors(set, *target.semiaxes);
    row.push_back({"area_shape_factor", "sf_A (26)", "", factors.area});
    row.push_back({"perimeter_shape_factor", "sf_P (27)", "", factors.perimeter});
  }
  row.push_back({"inertia_xx_ratio", "I_xx ratio", "", m.inertia.xx / solid.inertia.xx});
  row.push_back({"inertia_yy_ratio", "I_yy ratio", "", m.inertia.yy / solid.inertia.yy});
  row.push_back({"inertia_zz_ratio", "I_zz ratio", "", m.inertia.zz / solid.inertia.zz});
  length("centre_distance", "distance of the centres", norm(m.centre - solid.centre));
}

} // namespace ellipsoid::post
