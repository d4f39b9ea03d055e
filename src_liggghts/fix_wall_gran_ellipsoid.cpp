// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_wall_gran_ellipsoid.h"

#include "atom.h"
#include "ellipsoid_contact.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_property_atom.h"
#include "primitive_wall.h"

#include <algorithm>
#include <cstring>
#include <string>

using namespace LAMMPS_NS;
using ellipsoid_host::store;
using ellipsoid_host::vector;

FixWallGranEllipsoid::FixWallGranEllipsoid(LAMMPS* lmp, int narg, char** arg)
    : FixWallGran(lmp, narg, arg) {
  if (is_mesh_wall())
    error->fix_error(FLERR, this,
                     "style 'mesh' is not available for ellipsoids; use 'primitive type T "
                     "xplane|yplane|zplane POS'");
  for (int k = 0; k < narg; ++k)
    if (std::strstr(arg[k], "cylinder"))
      error->fix_error(FLERR, this,
                       (std::string("primitive '") + arg[k] +
                        "' is not available for ellipsoids; use 'xplane', 'yplane' or 'zplane'")
                           .c_str());
}

void FixWallGranEllipsoid::init() {
  FixWallGran::init();
  if (!atom->superquadric_flag)
    error->fix_error(FLERR, this, "needs particles with shape: use atom_style granular/ellipsoid");
  if (!impl->contact_match("surface", "smooth"))
    error->fix_error(FLERR, this, "needs 'surface smooth' among the model keywords; add it");
}

void FixWallGranEllipsoid::post_force_primitive(int) {
  double wall_velocity[3] = {0.0, 0.0, 0.0};
  if (shear_)
    wall_velocity[shearDim_] = vshear_;
  double** history = dnum() > 0 ? fix_history_primitive_->array_atom : nullptr;
  int* near;
  const int near_count = primitiveWall_->getNeighbors(near);
  for (int k = 0; k < near_count; ++k)
    if (atom->mask[near[k]] & groupbit)
      plane_contact(near[k], history ? history[near[k]] : nullptr, wall_velocity);
}

void FixWallGranEllipsoid::plane_contact(int i, double* history, double* wall_velocity) {
  double to_wall[3];
  const double gap_of_centre = primitiveWall_->resolveContact(x_[i], 0.0, to_wall); // >= 0: both sides are outside
  const ellipsoid::Vector3 plane_point = vector(to_wall);
  ellipsoid::ContactGeometry contact;
  if (gap_of_centre <= radius_[i] && gap_of_centre > 0.0) {
    const ellipsoid::EllipsoidShape shape = ellipsoid::make_shape(
        vector(atom->shape[i]), ellipsoid_host::quaternion(atom->quaternion[i]));
    contact = find_plane_contact(shape, plane_point, (1.0 / gap_of_centre) * plane_point);
  }
  if (contact.status == ellipsoid::ContactStatus::separated) {
    if (history)
      std::fill_n(history, dnum(), 0.0);
    return;
  }
  LCM::SurfacesIntersectData data;
  data.is_wall = true;
  data.is_non_spherical = true;
  data.i = i;
  data.contact_history = history;
  data.deltan = contact.overlap;
  data.reff = contact.reduced_radius;
  data.radi = contact.curvature_radius_i;
  curvature_radius_i = contact.curvature_radius_i;
  store(vector(x_[i]) + contact.point, data.contact_point);
  store(-plane_point, data.delta); // the host's normal: from the wall to the particle
  impl->compute_force(this, data, true, wall_velocity);
}
