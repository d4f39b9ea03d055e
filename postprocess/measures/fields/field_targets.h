// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Where fields are wanted, and how much a source there contributes: at points, or averaged over
// the planes of a profile.
#pragma once

#include "averages/coarse_graining_function.h"
#include "frame.h"
#include "periodic_cell.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace ellipsoid::post {

/// Numbers of a field at one target, all linear in the sources; a range of them belongs to a part.
enum FieldPart : std::size_t {
  field_number = 0,          ///< particles per volume
  field_mass = 1,            ///< m
  field_solid = 2,           ///< volume of the bodies
  field_spin_energy = 3,     ///< omega . I omega
  field_momentum = 4,        ///< m v
  field_spin = 7,            ///< I omega
  field_momentum_flux = 10,  ///< m v v
  field_inertia = 19,        ///< I
  field_spin_flux = 28,      ///< (I omega) v
  field_fabric = 37,         ///< V sum of n n over the particle's contacts
  field_contact_stress = 46, ///< f b
  field_couple_stress = 55,  ///< tau b
  field_boundary_force = 64, ///< -f of walls
  field_size = 67
};
using FieldSums = std::array<double, field_size>;

/// Which numbers of a source count: from first to last, without it.
struct FieldRange {
  std::size_t first, last;
};
constexpr FieldRange particle_range{field_number, field_contact_stress},
    contact_range{field_contact_stress, field_boundary_force},
    boundary_range{field_boundary_force, field_size};

/// The points at which fields are evaluated, and their sums.
class FieldTargets {
 public:
  virtual ~FieldTargets() = default;
  /// Adds source phi(r - point), all images of it.
  virtual void add_at(const Vector3& point, const FieldSums& source, FieldRange range) = 0;
  /// Adds source times the mean of phi(r - p) over the points p of a segment, all images of it.
  virtual void add_along(const Vector3& begin, const Vector3& end, const FieldSums& source,
                         FieldRange range) = 0;
  virtual const std::vector<FieldSums>& sums() const = 0;
  virtual void clear() = 0;
};

/// At points anywhere.
/// @param[in] longest segment that will be added (length)
std::unique_ptr<FieldTargets> point_targets(std::vector<Vector3> points,
                                            const CoarseGrainingFunction& function,
                                            const PeriodicCell& cell, double longest);

/// Averages over planes across the axis k (0 to 2) at these abscissae.
/// @param[in] section bounds of the part of the planes that counts; none: the whole cell
/// Throws InputError for a tilted cell whose images do not lie in the planes.
std::unique_ptr<FieldTargets> plane_targets(std::size_t axis, std::vector<double> abscissae,
                                            const std::optional<Box>& section,
                                            const CoarseGrainingFunction& function,
                                            const PeriodicCell& cell, double longest);

} // namespace ellipsoid::post
