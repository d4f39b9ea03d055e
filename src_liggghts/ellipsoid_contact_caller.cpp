// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid_contact_caller.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "tri_mesh.h"

namespace LIGGGHTS {
namespace ContactModels {

using ellipsoid_host::vector;

void EllipsoidContactCaller::add_record(const SurfacesIntersectData& contact, const double* force,
                                        LAMMPS_NS::Atom& atom, LAMMPS_NS::TriMesh* mesh) {
  const int i = contact.i, j = contact.j;
  ContactRecord r;
  r.particle_i = atom.tag[i];
  r.group_mask = atom.mask[i];
  r.position_i = r.position_j = vector(atom.x[i]);
  r.sphere_i = sphere_i_;
  if (!contact.is_wall) {
    r.particle_j = atom.tag[j];
    r.group_mask &= atom.mask[j];
    r.is_ghost_pair = j >= atom.nlocal;
    r.position_j = vector(atom.x[j]);
    r.sphere_j = sphere_j_;
  } else if (mesh) {
    r.particle_j = mesh->id(j);
  }
  r.point = vector(contact.contact_point);
  r.normal = -vector(contact.en);
  r.force = weight_ * vector(force);
  r.overlap = contact.deltan;
  r.reduced_radius = contact.reff;
  records_.push_back(r);
}

} // namespace ContactModels
} // namespace LIGGGHTS
