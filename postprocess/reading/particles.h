// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The particles of a frame as bodies: smooth ellipsoids or rigid unions of spheres.
// Lengths, velocities and masses in the units of the file.
#pragma once

#include "column_names.h"
#include "frame.h"
#include "math/vector3.h"
#include "multisphere/multisphere_template.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

struct Sphere {
  Vector3 centre; ///< in space (length)
  double radius = 0.0;
};

/// What a file tells of how a body lies.
enum class KnownOrientation {
  whole, ///< every turn is seen
  axis,  ///< of the body's x axis, not how it turns about it: chains of the host's spheres
  none   ///< spheres without a quaternion
};

struct Particle {
  std::int64_t id = 0;
  std::int64_t type = 1;
  double mass = 0.0;         ///< 0 when the file has none
  Vector3 principal_moments; ///< about the body's x, y, z (mass length^2), see has_moments
  Vector3 moments_per_mass;  ///< principal, of a clump (length^2); 0: those of its ellipsoid
  Vector3 centre, velocity, angular_velocity;
  /// The centre gone on beyond faces that repeat; only of sets that tell ways (length).
  Vector3 unwrapped_centre;
  Quaternion orientation;
  KnownOrientation known_orientation = KnownOrientation::whole;
  /// a, b, c along the body's x, y, z (length); of unions of spheres half their lengths
  Vector3 semiaxes;
  std::size_t first_sphere = 0, sphere_count = 0; ///< 0 spheres: a smooth ellipsoid
  bool is_host_body = false; ///< of the host's fix multisphere, or a sphere beside such bodies
  std::size_t row = 0;       ///< of the frame (of the first sphere for host multispheres)

  bool is_smooth() const { return sphere_count == 0; }
  double largest_axis() const;
  /// Direction of the largest semi-axis, of equal ones the first (unit, in space).
  Vector3 long_axis() const;
  double smallest_axis() const;
};

/// Whether a file has a quantity. One that is there but cannot be read stops those who ask for it.
class Availability {
 public:
  Availability(bool is_there = false, std::string fault = "")
      : is_there_(is_there), fault_(std::move(fault)) {}
  /// Throws InputError where a value is no number.
  explicit operator bool() const {
    require_readable();
    return is_there_;
  }
  /// To be called by who needs the quantity if the file has it.
  void require_readable() const {
    if (!fault_.empty())
      throw InputError(fault_);
  }
  /// There, and all of it numbers.
  bool is_known() const { return is_there_ && fault_.empty(); }
  const std::string& fault() const { return fault_; }

 private:
  bool is_there_;
  std::string fault_; ///< the first value that is no number, as a message
};

struct ParticleSet {
  std::vector<Particle> particles;
  std::vector<Sphere> spheres; ///< of all multi-sphere particles, a particle's own in one run
  /// Of the host's bodies: ids of the spheres, by which lists of contacts name them.
  std::vector<std::int64_t> sphere_ids;
  Availability has_types, has_masses, has_velocities, has_spins, has_moments;
  /// The host's bodies whose mass centre is not known from their spheres (0 where all are symmetric
  /// about a point): their velocities are those of the centroid of the centres.
  std::size_t asymmetric_bodies = 0;
  Box box; ///< of the frame; where it repeats, so do the particles
  /// Whether the file tells how often particles went around a box that repeats.
  Availability tells_ways;
  std::vector<std::string> remarks; ///< how columns were understood that could mean something else
};

/// Mean over some particles of the smallest semi-axis (length): the b of tables.
double mean_smallest_axis(const ParticleSet& set, const std::vector<std::size_t>& members);
/// Mean over some particles of the largest semi-axis (length): the a of tables.
double mean_largest_axis(const ParticleSet& set, const std::vector<std::size_t>& members);
/// The indices of all particles.
std::vector<std::size_t> all_members(const ParticleSet& set);

/// How columns are understood where the file does not say it.
struct ParticleOptions {
  std::vector<double> semiaxes;         ///< a b c for files without shape columns; empty: not given
  std::optional<int> subspheres;        ///< number for files without a column
  std::optional<SphereSpacing> spacing; ///< for files without a column; else that of the paper
  std::optional<double> size_scale;     ///< factor on sizes (0.5 where a file holds whole axes)
  std::vector<std::string> clumps;      ///< "NUMBER=FILE": spheres of clumps
  ColumnNames columns;                  ///< foreign names
  std::string bodies;   ///< column whose values > 0 join spheres to bodies, or "none"
  std::string periodic; ///< axes along which the box repeats, or "none"; empty: as the file says
};

/// Bodies of one frame, sorted by id: measures do not depend on the order of the rows.
///
/// Columns: x y z (or xu, xs, xsu ...), ix iy iz, shapex shapey shapez (semi-axes) or radius,
/// quat1..quat4, id, type, mass, vx.., omegax.., f_subspheres (number N; 0 or missing: smooth),
/// f_spacing (1000 + n: clump n). LAMMPS's names quatw..quatk, c_orient[*], c_diameter[*]: whole
/// axes, which are halved. Rows with a column `id_multisphere` > 0 are spheres of a rigid body of
/// the host. Throws InputError for missing columns, sizes <= 0, quaternions of length 0, impossible
/// N, ids that come twice, superquadrics that are no ellipsoids, and columns whose meaning is not
/// sure.
ParticleSet particles_of(const Frame& frame, const ParticleOptions& options);

} // namespace ellipsoid::post
