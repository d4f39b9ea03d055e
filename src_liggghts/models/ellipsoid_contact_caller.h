// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "host_contact.h"
#include "lmptype.h"
#include "math/vector3.h"

#include <vector>

namespace LAMMPS_NS {
class Atom;
class Compute;
class Error;
class Force;
class Modify;
class TriMesh;
class Update;
} // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace ContactModels {

/// One contact as it acted in the last time step.
struct ContactRecord {
  int index_i = 0, index_j = 0; ///< local indices on this rank; index_j only of particles
  int particle_i = 0;           ///< id of the first particle
  int particle_j = 0; ///< id of the second; of the triangle at mesh walls, -1 at other walls
  int group_mask = 0; ///< groups that both particles (the one at a wall) belong to
  bool is_ghost_pair = false;     ///< the second is a ghost: its rank has the contact, too
  int sphere_i = 0, sphere_j = 0; ///< numbers of the sub-spheres from 1; 0: none
  ellipsoid::Vector3 position_i,
      position_j;              ///< centres; at walls both that of the particle (length)
  ellipsoid::Vector3 point;    ///< middle of the overlap, in space (length)
  ellipsoid::Vector3 normal;   ///< unit, from the first to the second or the wall
  ellipsoid::Vector3 force;    ///< on the first, of all contact models together (force)
  double overlap = 0.0;        ///< h (length)
  double reduced_radius = 0.0; ///< R of (19), of the spheres for multi-spheres (length)
  double area = 0.0;           ///< of the contact (length^2)
  double weight = 1.0;         ///< of its force in the sum

  /// Of a contact between particles: whether this record is the one that counts. A contact with a
  /// ghost is noted on both sides.
  bool counts() const;
};

/// Base class of the pair style and the walls that fill in the contact geometry which the surface
/// models of ellipsoids expect; those of the host do not have it.
class EllipsoidContactCaller {
 public:
  virtual ~EllipsoidContactCaller() {}
  /// Curvature radii (length) of the contact in work: of i, and of j (not used at walls).
  double curvature_radius_i = 0.0, curvature_radius_j = 0.0;

  /// Area of the contact in work over pi R h; 1 where the contact is a circle.
  double area_factor = 1.0;

  /// Of multi-spheres: the spheres of the contact in work, counted from 0 (-1: none), and the
  /// weight of its force in the sum.
  void set_spheres(int sphere_i, int sphere_j, double weight) {
    sphere_i_ = sphere_i + 1;
    sphere_j_ = sphere_j + 1;
    weight_ = weight;
  }

  /// The pair style, if it is of this kind; all walls of this kind, in the order of definition.
  static EllipsoidContactCaller* pair_of(const LAMMPS_NS::Force& force);
  static std::vector<EllipsoidContactCaller*> walls_of(const LAMMPS_NS::Modify& modify);

  /// From now on every contact that gives a force is noted down.
  void keep_records() { keeps_records_ = true; }
  bool keeps_records() const { return keeps_records_; }
  /// A new pass over all contacts begins.
  void begin_records(LAMMPS_NS::bigint step) {
    records_.clear();
    records_step_ = step;
  }
  /// Those of the present time step; stops with an error of the compute where there are none.
  const std::vector<ContactRecord>& records_of(LAMMPS_NS::Compute& compute,
                                               const LAMMPS_NS::Update& update,
                                               LAMMPS_NS::Error& error) const;

  /// Those of the last pass, wherever it was.
  const std::vector<ContactRecord>& records() const { return records_; }

  /// Values, not references: the caller's own may then live in registers.
  /// @param[in] force on i, of all models
  /// @param[in] mesh  that the contact's triangle belongs to; null elsewhere
  void add_record(SurfacesIntersectData contact, ellipsoid::Vector3 force, LAMMPS_NS::Atom& atom,
                  LAMMPS_NS::TriMesh* mesh);

 private:
  bool keeps_records_ = false;
  int sphere_i_ = 0, sphere_j_ = 0;
  double weight_ = 1.0;
  LAMMPS_NS::bigint records_step_ = -1;
  std::vector<ContactRecord> records_;
};

} // namespace ContactModels
} // namespace LIGGGHTS
