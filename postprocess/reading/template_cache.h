// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "math/vector3.h"
#include "multisphere/multisphere_template.h"

#include <map>
#include <tuple>

namespace ellipsoid::post {

/// Multi-sphere templates by size, number and spacing; each is computed once.
class TemplateCache {
 public:
  /// @param[in] semiaxes a > b = c (length)
  /// Throws std::invalid_argument when it cannot be built (even N, a <= b, b != c, too small N).
  const MultisphereTemplate& find(const Vector3& semiaxes, int subspheres, SphereSpacing spacing);

 private:
  std::map<std::tuple<double, double, int, SphereSpacing>, MultisphereTemplate> m_templates;
};

} // namespace ellipsoid::post
