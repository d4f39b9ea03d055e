// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "particle_to_insert_ellipsoid.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "fix_property_atom.h"
#include "insertion_space.h"
#include "modify.h"

#include <utility>

using namespace LAMMPS_NS;
using ellipsoid_host::store;

int ParticleToInsertEllipsoid::check_near_set_x_v_omega(double* x, double* v, double* omega,
                                                        double* quat,
                                                        ellipsoid_host::NearBodies& near) {
  if (has_orientation)
    store(orientation, quat);
  if (!ellipsoid_host::asks_for_room(this))
    return ParticleToInsertSuperquadric::check_near_set_x_v_omega(x, v, omega, quat, near);
  if (!ellipsoid_host::occupy(*this, x, quat))
    return 0;
  // particles of the host's templates find room by this list
  ellipsoid_host::add_body(near, *this, x, quat);
  return ParticleToInsertSuperquadric::set_x_v_omega(x, v, omega, quat);
}

int ParticleToInsertEllipsoid::set_x_v_omega(double* x, double* v, double* omega, double* quat) {
  if (has_orientation)
    store(orientation, quat);
  return ParticleToInsertSuperquadric::set_x_v_omega(x, v, omega, quat);
}

int ParticleToInsertEllipsoid::insert() {
  const int inserted = ParticleToInsertSuperquadric::insert();
  if (subspheres == 0)
    return inserted;
  const std::pair<const char*, double> values[] = {{"subspheres", static_cast<double>(subspheres)},
                                                   {"spacing", static_cast<double>(spacing)}};
  for (const auto& value : values) {
    auto* fix = static_cast<FixPropertyAtom*>(modify->find_fix_property(
        value.first, "property/atom", "scalar", 0, 0, "fix particletemplate/ellipsoid"));
    for (int i = atom->nlocal - inserted; i < atom->nlocal; ++i)
      fix->vector_atom[i] = value.second;
  }
  return inserted;
}
