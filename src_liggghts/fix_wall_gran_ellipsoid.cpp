// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_wall_gran_ellipsoid.h"

#include "atom.h"
#include "ellipsoid_contact.h"
#include "ellipsoid_host.h"
#include "ellipsoid_models.h"
#include "error.h"
#include "fix_property_atom.h"
#include "primitive_wall.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace LAMMPS_NS;
using ellipsoid_host::store;
using ellipsoid_host::vector;

namespace {

/// The host reads 'primitive type T PLANE POS' without looking whether the words are there, and says
/// little about wrong ones; so they are checked before it does. Returns `arg`.
char** checked(LAMMPS* lmp, int narg, char** arg) {
  ellipsoid_host::ArgumentReader reader(lmp->error, "wall/gran/ellipsoid", arg[0], narg, arg, 3);
  while (!reader.done()) {
    const std::string keyword = reader.keyword();
    if (keyword == "mesh")
      reader.complain("style 'mesh' is not available for ellipsoids; use 'primitive type T "
                      "xplane|yplane|zplane POS'");
    if (keyword != "primitive")
      continue;
    reader.choice("primitive", {"type"});
    reader.integer("type", 1, lmp->atom->ntypes);
    const std::vector<std::string> planes{"xplane", "yplane", "zplane"};
    const auto plane = static_cast<std::size_t>(reader.choice("primitive type T", planes));
    reader.number(planes[plane], -HUGE_VAL, HUGE_VAL);
  }
  return arg;
}

} // namespace

FixWallGranEllipsoid::FixWallGranEllipsoid(LAMMPS* lmp, int narg, char** arg)
    : FixWallGran(lmp, narg, checked(lmp, narg, arg)), particles_(lmp) {
  multisphere_ = impl->contact_match("surface", "multisphere");
  if (!multisphere_ && !impl->contact_match("surface", "smooth"))
    error->fix_error(FLERR, this,
                     "needs 'surface smooth' or 'surface multisphere' among the models; add it");
  const std::string complaint = LCM::unsuitable_model(*impl) + LCM::unsuitable_setting(narg, arg);
  if (!complaint.empty())
    error->fix_error(FLERR, this, complaint.c_str());
  if (multisphere_) { // one slot per contact: the number of the sphere + 1, and the models' values
    slots_ = impl->get_history_offset("contacts");
    rule_ = impl->get_history_offset("multicontact") ? ellipsoid::MulticontactRule::average
                                                     : ellipsoid::MulticontactRule::sum;
    slot_values_ = 1 + dnum();
    setDnum(slots_ * slot_values_);
  }
}

void FixWallGranEllipsoid::init() {
  FixWallGran::init();
  if (!atom->superquadric_flag)
    error->fix_error(FLERR, this, "needs particles with shape: use atom_style granular/ellipsoid");
}

void FixWallGranEllipsoid::post_force_primitive(int) {
  double wall_velocity[3] = {0.0, 0.0, 0.0};
  if (shear_)
    wall_velocity[shearDim_] = vshear_;
  double** history = dnum() > 0 ? fix_history_primitive_->array_atom : nullptr;
  if (multisphere_)
    particles_.find_properties();
  int* near;
  const int near_count = primitiveWall_->getNeighbors(near);
  for (int k = 0; k < near_count; ++k) {
    const int i = near[k];
    if (!(atom->mask[i] & groupbit))
      continue;
    if (multisphere_)
      multisphere_contacts(i, history ? history[i] : nullptr, wall_velocity);
    else
      smooth_contact(i, history ? history[i] : nullptr, wall_velocity);
  }
}

LCM::SurfacesIntersectData
FixWallGranEllipsoid::wall_contact(int i, const ellipsoid::Vector3& normal,
                                   const ellipsoid::Vector3& point, double overlap, double radius,
                                   double* history) {
  LCM::SurfacesIntersectData data;
  data.is_wall = true;
  data.is_non_spherical = true;
  data.i = i;
  data.contact_history = history;
  data.deltan = overlap;
  data.reff = data.radi = curvature_radius_i = radius;
  store(vector(x_[i]) + point, data.contact_point);
  store(-normal, data.delta); // the host's normal: from the wall to the particle
  return data;
}

void FixWallGranEllipsoid::smooth_contact(int i, double* history, double* wall_velocity) {
  double to_wall[3];
  const double distance = primitiveWall_->resolveContact(x_[i], 0.0, to_wall);
  const ellipsoid::Vector3 plane_point = vector(to_wall);
  ellipsoid::ContactGeometry contact;
  if (distance <= radius_[i] && distance > 0.0) {
    const ellipsoid::EllipsoidShape shape = ellipsoid::make_shape(
        vector(atom->shape[i]), ellipsoid_host::quaternion(atom->quaternion[i]));
    contact = find_plane_contact(shape, plane_point, (1.0 / distance) * plane_point);
  }
  if (contact.status == ellipsoid::ContactStatus::separated) {
    if (history)
      std::fill_n(history, dnum(), 0.0);
    return;
  }
  LCM::SurfacesIntersectData data = wall_contact(i, contact.normal, contact.point, contact.overlap,
                                                 contact.curvature_radius_i, history);
  impl->compute_force(this, data, true, wall_velocity);
}

void FixWallGranEllipsoid::multisphere_contacts(int i, double* history, double* wall_velocity) {
  double to_wall[3];
  const double distance = primitiveWall_->resolveContact(x_[i], 0.0, to_wall);
  const ellipsoid::Vector3 plane_point = vector(to_wall);
  found_.clear();
  if (distance <= radius_[i] && distance > 0.0)
    find_plane_contacts(particles_.make_pose(i), plane_point, (1.0 / distance) * plane_point,
                        found_);
  keep_slots(i, history);
  const double weight = multicontact_weight(rule_, std::max(1, static_cast<int>(found_.size())));
  for (std::size_t k = 0; k < found_.size(); ++k) {
    const ellipsoid::SphereContact& c = found_[k];
    const ellipsoid::Vector3 force = vector(f_[i]), torque = vector(atom->torque[i]);
    set_spheres(c.sphere_i, -1, weight);
    LCM::SurfacesIntersectData data =
        wall_contact(i, c.normal, c.point, c.overlap, c.radius_i,
                     &history[slot_values_ * static_cast<int>(k) + 1]);
    impl->compute_force(this, data, true, wall_velocity);
    if (weight != 1.0) {
      store(force + weight * (vector(f_[i]) - force), f_[i]);
      store(torque + weight * (vector(atom->torque[i]) - torque), atom->torque[i]);
    }
  }
}

/// The slots follow the order of the contacts found; a contact that goes on takes its values along.
void FixWallGranEllipsoid::keep_slots(int i, double* history) {
  if (static_cast<int>(found_.size()) > slots_)
    error->one(FLERR, ("Fix wall/gran/ellipsoid (id " + std::string(id) + "): atom " +
                       std::to_string(atom->tag[i]) + " touches at " +
                       std::to_string(found_.size()) + " places, setting 'contacts' allows " +
                       std::to_string(slots_) + "; raise it")
                          .c_str());
  slots_before_.assign(history, history + dnum());
  std::fill_n(history, dnum(), 0.0);
  for (std::size_t k = 0; k < found_.size(); ++k) {
    double* slot = &history[slot_values_ * static_cast<int>(k)];
    slot[0] = found_[k].sphere_i + 1;
    for (int s = 0; s < slots_; ++s) {
      const double* before = &slots_before_[static_cast<std::size_t>(slot_values_ * s)];
      if (before[0] == slot[0])
        std::copy(before, before + slot_values_, slot);
    }
  }
}
