// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The particles of a frame as bodies: smooth ellipsoids or rigid unions of spheres.
// Lengths, velocities and masses in the units of the file.
#pragma once

#include "frame.h"
#include "math/vector3.h"
#include "multisphere/multisphere_template.h"

#include <cstdint>
#include <vector>

namespace ellipsoid::post {

struct Sphere {
  Vector3 centre; ///< in space (length)
  double radius = 0.0;
};

struct Particle {
  std::int64_t id = 0;
  std::int64_t type = 1;
  double mass = 0.0; ///< 0 when the file has none
  Vector3 centre, velocity, angular_velocity;
  Quaternion orientation;
  Vector3 semiaxes; ///< a, b, c along the body's x, y, z (length); of the circumscribed ellipsoid
  std::size_t first_sphere = 0, sphere_count = 0; ///< 0 spheres: a smooth ellipsoid
  std::size_t row = 0; ///< of the frame (of the first sphere for host multispheres)

  bool is_smooth() const { return sphere_count == 0; }
  double largest_axis() const;
  double smallest_axis() const;
};

struct ParticleSet {
  std::vector<Particle> particles;
  std::vector<Sphere> spheres; ///< of all multi-sphere particles, a particle's own in one run
  bool has_velocities = false;
};

/// Mean over some particles of the smallest semi-axis (length): the b of tables.
double mean_smallest_axis(const ParticleSet& set, const std::vector<std::size_t>& members);
/// Mean over some particles of the largest semi-axis (length): the a of tables.
double mean_largest_axis(const ParticleSet& set, const std::vector<std::size_t>& members);
/// The indices of all particles.
std::vector<std::size_t> all_members(const ParticleSet& set);

/// How columns are understood where the file does not say it.
struct ParticleOptions {
  std::vector<double> semiaxes; ///< a b c for files without shape columns; empty: not given
  int subspheres = 0;           ///< number for files without a column; 0: not given
  SphereSpacing spacing = SphereSpacing::paper; ///< for files without a column
  double sphere_size_scale = 1.; ///< factor on sizes (0.5 where a file holds diameters)
};

/// Bodies of one frame, sorted by id: measures do not depend on the order of the rows.
///
/// Columns: x y z (or xu, xs, xsu ...), shapex shapey shapez (semi-axes) or radius, quat1..quat4,
/// id, type, mass, vx.., omegax.., f_subspheres (number N; 0 or missing: smooth), f_spacing.
/// Rows with a column `id_multisphere` or `mol` > 0 are spheres of a rigid body of the host.
/// Throws InputError for missing columns, sizes <= 0, quaternions of length 0, impossible N.
ParticleSet particles_of(const Frame& frame, const ParticleOptions& options);

} // namespace ellipsoid::post
