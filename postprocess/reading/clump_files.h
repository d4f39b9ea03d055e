// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "multisphere/clump_template.h"

#include <map>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// The clumps of a file's particles, from lists of spheres that the user names.
class ClumpFiles {
 public:
  /// @param[in] assignments "NUMBER=FILE": clump NUMBER, as in f_spacing less 1000
  /// Throws InputError: no such assignment, a file that cannot be read, bad spheres.
  explicit ClumpFiles(const std::vector<std::string>& assignments);

  /// Of a particle with this f_spacing.
  /// Throws std::invalid_argument: the clump is not given, has another number of spheres or another
  /// shape.
  const ClumpTemplate& find(double spacing, int count, const Vector3& semiaxes) const;

 private:
  std::map<int, ClumpTemplate> clumps_;
};

} // namespace ellipsoid::post
