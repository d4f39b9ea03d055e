// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid_contact_caller.h"

#include "atom.h"
#include "compute.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "modify.h"
#include "pair.h"
#include "tri_mesh.h"
#include "update.h"

#include <cmath>

namespace LIGGGHTS {
namespace ContactModels {

using namespace LAMMPS_NS;
using ellipsoid_host::vector;

bool ContactRecord::counts() const {
  if (!is_ghost_pair || particle_i < particle_j)
    return true;
  const ellipsoid::Vector3 d = position_j - position_i; // of a particle and its own image: one
  return particle_i == particle_j &&
         (d.x > 0.0 || (d.x == 0.0 && d.y > 0.0) || (d.x == 0.0 && d.y == 0.0 && d.z > 0.0));
}

EllipsoidContactCaller* EllipsoidContactCaller::pair_of(const Force& force) {
  return dynamic_cast<EllipsoidContactCaller*>(force.pair);
}

std::vector<EllipsoidContactCaller*> EllipsoidContactCaller::walls_of(const Modify& modify) {
  std::vector<EllipsoidContactCaller*> walls;
  for (int k = 0; k < modify.nfix; ++k)
    if (auto* wall = dynamic_cast<EllipsoidContactCaller*>(modify.fix[k]))
      walls.push_back(wall);
  return walls;
}

const std::vector<ContactRecord>&
EllipsoidContactCaller::records_of(Compute& compute, const Update& update, Error& error) const {
  if (records_step_ != update.ntimestep)
    error.compute_error(FLERR, &compute,
                        "the forces of this time step are not computed; use it in "
                        "a 'run' (also of 0 steps)");
  return records_;
}

void EllipsoidContactCaller::add_record(SurfacesIntersectData contact, ellipsoid::Vector3 force,
                                        Atom& atom, TriMesh* mesh) {
  const int i = contact.i, j = contact.j;
  ContactRecord r;
  r.index_i = i;
  r.particle_i = atom.tag[i];
  r.group_mask = atom.mask[i];
  r.position_i = r.position_j = vector(atom.x[i]);
  r.sphere_i = sphere_i_;
  if (!contact.is_wall) {
    r.index_j = j;
    r.particle_j = atom.tag[j];
    r.group_mask &= atom.mask[j];
    r.is_ghost_pair = j >= atom.nlocal;
    r.position_j = vector(atom.x[j]);
    r.sphere_j = sphere_j_;
  } else {
    r.particle_j = mesh ? mesh->id(j) : -1;
  }
  r.point = vector(contact.contact_point);
  r.normal = -vector(contact.en);
  r.weight = weight_;
  r.force = weight_ * force;
  r.overlap = contact.deltan;
  r.reduced_radius = contact.reff;
  r.area =
      area_factor * M_PI * contact.reff * contact.deltan; // Hertz: a circle of radius sqrt(R h)
  records_.push_back(r);
}

} // namespace ContactModels
} // namespace LIGGGHTS
