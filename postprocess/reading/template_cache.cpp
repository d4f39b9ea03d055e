// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "template_cache.h"

#include "multisphere/ellipsoid_spheres.h"

#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace ellipsoid::post {

const SphereSet& TemplateCache::find(const Vector3& semiaxes, int subspheres,
                                     SphereSpacing spacing) {
  constexpr double same_axis = 1e-5; // relative: two axes written with six digits
  const bool is_planar = ellipsoid::is_planar(spacing);
  if (!is_planar && std::abs(semiaxes.y - semiaxes.z) > same_axis * semiaxes.y)
    throw std::invalid_argument(fmt::format(
        "chains of spheres need equal semi-axes b = c, not {} and {}", semiaxes.y, semiaxes.z));
  const auto key = std::make_tuple(semiaxes.x, semiaxes.y, is_planar ? semiaxes.z : semiaxes.y,
                                   subspheres, spacing);
  auto it = templates_.find(key);
  if (it == templates_.end())
    it = templates_
             .emplace(key, is_planar ? make_ellipsoid_spheres(semiaxes, subspheres, spacing)
                                     : spheres_of(make_multisphere(semiaxes.x, semiaxes.y,
                                                                   subspheres, spacing)))
             .first;
  return it->second;
}

} // namespace ellipsoid::post
