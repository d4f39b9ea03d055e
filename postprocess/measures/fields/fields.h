// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Continuous fields from particles and their contacts: Goldhirsch 2010, Granular Matter 12,
// 239-252; with walls: Weinhart, Thornton, Luding, Bokhove 2012, Granular Matter 14, 289-294.
// Stresses are positive in compression.
#pragma once

#include "field_targets.h"
#include "particles.h"

#include <optional>
#include <vector>

namespace ellipsoid::post {

/// A contact of a particle with another one or with a wall, and its force.
struct ForceContact {
  std::size_t i = 0;
  std::optional<std::size_t> j;  ///< none: a wall
  std::optional<Vector3> point;  ///< (length); none: on the line between the centres
  Vector3 force;                 ///< on i (force)
  std::optional<Vector3> normal; ///< unit
};

struct FieldOptions {
  std::optional<double> density; ///< of the particles' material where the file has no masses
};

/// Adds a frame's particles and contacts to the sums of the targets.
/// Throws InputError without masses, and for contacts without a point at a wall.
void add_frame(FieldTargets& targets, const ParticleSet& set,
               const std::vector<ForceContact>& contacts, const PeriodicCell& cell,
               const FieldOptions& options);

/// 3x3 numbers, row by row.
using Tensor3 = std::array<double, 9>;

struct Fields {
  double number_density = 0.0; ///< (1/length^3)
  double density = 0.0;        ///< (mass/length^3)
  double solid_fraction = 0.0;
  Vector3 momentum;                    ///< (mass/length^2/time)
  Vector3 velocity;                    ///< momentum / density
  Vector3 angular_velocity;            ///< (sum I)^-1 sum I omega
  double temperature = 0.0;            ///< of translation: trace of the kinetic stress / 3 density
  double rotational_temperature = 0.0; ///< <omega' . I omega'> / 3 density (velocity^2)
  Tensor3 kinetic_stress{}, contact_stress{}, stress{}; ///< (pressure)
  Tensor3 couple_stress{};                              ///< with its kinetic part (force/length)
  Tensor3 fabric{};       ///< its trace is solid fraction times coordination number
  Vector3 boundary_force; ///< of the material on walls, per volume
};

/// The fields of sums, for example means over frames.
Fields fields_of(const FieldSums& sums);

/// Sums in coordinates turned by these axes: the components along the columns.
FieldSums turned(const FieldSums& sums, const Rotation3& axes);

} // namespace ellipsoid::post
