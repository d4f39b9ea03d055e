// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// One particle of fix particletemplate/ellipsoid on its way into the simulation.
#pragma once

#include "host_insertion.h"
#include "math/vector3.h"

namespace LAMMPS_NS {

/// A particle to insert whose orientation may be its template's, not the inserting fix's.
class ParticleToInsertEllipsoid : public ParticleToInsertSuperquadric {
 public:
  explicit ParticleToInsertEllipsoid(class LAMMPS* lmp) : ParticleToInsertSuperquadric(lmp) {}
  int check_near_set_x_v_omega(double* x, double* v, double* omega, double* quat,
                               ellipsoid_host::NearBodies& near) override;
  int set_x_v_omega(double* x, double* v, double* omega, double* quat) override;
  int insert() override;

  class Fix* source = nullptr;  ///< its template
  int subspheres = 0;           ///< N of a multi-sphere particle, 0: smooth
  int spacing = 0;              ///< the number of SphereSpacing, or of the clump
  bool has_orientation = false; ///< use `orientation`, whatever the inserting fix says
  ellipsoid::Quaternion orientation;
};

} // namespace LAMMPS_NS
