// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "math/vector3.h"
#include "multisphere/clump.h"
#include "multisphere/multisphere_template.h"

#include <map>
#include <tuple>

namespace ellipsoid::post {

/// Multi-sphere templates by size, number and spacing; each is computed once.
class TemplateCache {
 public:
  /// Throws std::invalid_argument when it cannot be built (even N, a <= b, b != c, too small N).
  /// @param[in] semiaxes a > b = c for chains, any for the spacings medial and minimax_volume
  ///            (length)
  const SphereSet& find(const Vector3& semiaxes, int subspheres, SphereSpacing spacing);

 private:
  std::map<std::tuple<double, double, double, int, SphereSpacing>, SphereSet> templates_;
};

} // namespace ellipsoid::post
