// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Volume, bounding sphere and moments of a template's particles, by their semi-axes: those of an
// ellipsoid, or of a clump in the size that the second semi-axis says.
#pragma once

#include "multisphere/clump_template.h"

#include <optional>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

class TemplateBody {
 public:
  /// Reads a clump from a file of spheres, on the first rank; lengths are multiplied by `scale`.
  /// @throws std::invalid_argument one line: the file and what is wrong with it
  void read_clump(LAMMPS_NS::LAMMPS* lmp, const std::string& file, double scale);
  /// Writes the clump's spheres in its own frame, on the first rank.
  /// @throws std::invalid_argument the file cannot be written (on that rank)
  void write_clump(LAMMPS_NS::LAMMPS* lmp, const std::string& file, const std::string& title) const;

  const std::optional<ellipsoid::ClumpTemplate>& clump() const { return clump_; }
  double volume(const ellipsoid::Vector3& semiaxes) const;
  double surface_area(const ellipsoid::Vector3& semiaxes) const;
  double bounding_radius(const ellipsoid::Vector3& semiaxes) const;
  /// For constant density.
  ellipsoid::Vector3 principal_moments(const ellipsoid::Vector3& semiaxes, double mass) const;

 private:
  std::optional<ellipsoid::ClumpTemplate> clump_; // none: an ellipsoid

  double size(const ellipsoid::Vector3& semiaxes) const { return semiaxes.y / clump_->semiaxes.y; }
};

} // namespace ellipsoid_host
